import { Camera, round_step } from '@/map/camera';

function camera_of(width: number, height: number) {
  const camera = new Camera();
  camera.resize(width, height);
  return camera;
}

test('a place goes to the screen and comes back', () => {
  const camera = camera_of(800, 600);
  camera.look_at(3, -2);
  const [x, y] = camera.to_world(...camera.to_screen(7.5, 4.25));
  expect(x).toBeCloseTo(7.5);
  expect(y).toBeCloseTo(4.25);
});

test('north is up', () => {
  const camera = camera_of(800, 600);
  expect(camera.to_screen(0, 10)[1]).toBeLessThan(camera.to_screen(0, 0)[1]);
});

test('what is under the pointer stays there when zooming', () => {
  const camera = camera_of(800, 600);
  const before = camera.to_world(120, 80);
  camera.zoom(3, 120, 80);
  const after = camera.to_world(120, 80);
  expect(after[0]).toBeCloseTo(before[0]);
  expect(after[1]).toBeCloseTo(before[1]);
});

test('a fitted box is in the window whole', () => {
  const camera = camera_of(800, 200);
  camera.fit({ left: -10, bottom: 5, right: 40, top: 65 });
  for (const [x, y] of [[-10, 5], [40, 65]] as const) {
    const [x_px, y_px] = camera.to_screen(x, y);
    expect(x_px).toBeGreaterThanOrEqual(0);
    expect(x_px).toBeLessThanOrEqual(800);
    expect(y_px).toBeGreaterThanOrEqual(0);
    expect(y_px).toBeLessThanOrEqual(200);
  }
});

test.each([[0.7, 1], [1, 1], [1.3, 2], [3, 5], [60, 100], [0.03, 0.05]])(
  'a step of at least %d is %d',
  (least, step) => expect(round_step(least)).toBeCloseTo(step),
);
