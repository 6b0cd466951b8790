import type { Scene } from '@/api/types';
import { Camera } from '@/map/camera';
import { labels_of } from '@/map/labels';

test('a point whose name would lie on another goes without', () => {
  const scene = {
    rooms: [], base: null, target: null, start: { x: 4, y: 22 },
    points: [
      { name: 'StartPlace', x: 4, y: 22, r: 0 }, { name: 'Sentry4', x: 40, y: 22, r: 0 },
      { name: 'Sentry6', x: 40, y: 22, r: 0 },
    ],
  } as unknown as Scene;
  expect(labels_of(new Camera(), scene).map((label) => label.text)).toEqual(['Start', 'Sentry4']);
});
