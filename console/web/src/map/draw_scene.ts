import type { Scene } from '@/api/types';
import { box_of, round_step, type Camera } from '@/map/camera';
import type { Palette } from '@/map/palette';

type Pen = CanvasRenderingContext2D;

const kGridLeast_px = 24;

/** The area, its grid and all that stands still, from the ground up. */
export function draw_scene(pen: Pen, camera: Camera, scene: Scene | null, colours: Palette): void {
  if (!scene) return draw_grid(pen, camera, colours);
  draw_area(pen, camera, scene, colours);
  draw_rooms(pen, camera, scene, colours);
  draw_grid(pen, camera, colours);
  draw_places(pen, camera, scene, colours);
  draw_discs(pen, camera, scene, colours);
  draw_walls(pen, camera, scene, colours);
  draw_doors(pen, camera, scene, colours);
}

function draw_area(pen: Pen, camera: Camera, scene: Scene, colours: Palette): void {
  const box = box_of(scene);
  const [left, top] = camera.to_screen(box.left, box.top);
  const [right, bottom] = camera.to_screen(box.right, box.bottom);
  pen.fillStyle = colours.paper;
  pen.fillRect(left, top, right - left, bottom - top);
  pen.strokeStyle = colours.faint;
  pen.lineWidth = 1;
  pen.strokeRect(left, top, right - left, bottom - top);
}

function draw_rooms(pen: Pen, camera: Camera, scene: Scene, colours: Palette): void {
  pen.fillStyle = colours.room;
  for (const room of scene.rooms) {
    path_of(pen, camera, room.outline);
    pen.fill();
  }
  pen.strokeStyle = colours.hall;
  pen.lineCap = 'butt';
  for (const hall of scene.halls) {
    pen.lineWidth = Math.max(hall.width_m * camera.px_per_m, 1);
    path_of(pen, camera, hall.centre);
    pen.stroke();
  }
}

function draw_grid(pen: Pen, camera: Camera, colours: Palette): void {
  const step_m = round_step(kGridLeast_px / camera.px_per_m);
  const [left, top] = camera.to_world(0, 0);
  const [right, bottom] = camera.to_world(camera.width_px, camera.height_px);
  pen.strokeStyle = colours.grid;
  pen.lineWidth = 1;
  pen.beginPath();
  for (let x = Math.ceil(left / step_m) * step_m; x <= right; x += step_m) {
    const x_px = Math.round(camera.to_screen(x, 0)[0]) + 0.5;
    pen.moveTo(x_px, 0);
    pen.lineTo(x_px, camera.height_px);
  }
  for (let y = Math.ceil(bottom / step_m) * step_m; y <= top; y += step_m) {
    const y_px = Math.round(camera.to_screen(0, y)[1]) + 0.5;
    pen.moveTo(0, y_px);
    pen.lineTo(camera.width_px, y_px);
  }
  pen.stroke();
}

function draw_places(pen: Pen, camera: Camera, scene: Scene, colours: Palette): void {
  if (scene.base) {
    circle(pen, camera, scene.base.x, scene.base.y, scene.base.r);
    pen.fillStyle = colours.base;
    pen.fill();
  }
  pen.strokeStyle = colours.faint;
  pen.lineWidth = 1.5;
  for (const point of scene.points) {
    circle(pen, camera, point.x, point.y, Math.max(point.r, 4 / camera.px_per_m));
    pen.stroke();
  }
}

function draw_discs(pen: Pen, camera: Camera, scene: Scene, colours: Palette): void {
  pen.fillStyle = colours.disc;
  for (const [x, y, r] of scene.discs) {
    circle(pen, camera, x, y, r);
    pen.fill();
  }
}

function draw_walls(pen: Pen, camera: Camera, scene: Scene, colours: Palette): void {
  pen.strokeStyle = colours.wall;
  pen.lineWidth = Math.min(Math.max(0.15 * camera.px_per_m, 1.5), 4);
  pen.lineCap = 'round';
  pen.beginPath();
  for (const [x1, y1, x2, y2] of scene.walls) {
    pen.moveTo(...camera.to_screen(x1, y1));
    pen.lineTo(...camera.to_screen(x2, y2));
  }
  pen.stroke();
}

function draw_doors(pen: Pen, camera: Camera, scene: Scene, colours: Palette): void {
  pen.strokeStyle = colours.accent;
  pen.lineWidth = 2;
  pen.setLineDash([3, 3]);
  pen.beginPath();
  for (const door of scene.doors) {
    pen.moveTo(...camera.to_screen(...door.from));
    pen.lineTo(...camera.to_screen(...door.to));
  }
  pen.stroke();
  pen.setLineDash([]);
}

function path_of(pen: Pen, camera: Camera, places: [number, number][]): void {
  pen.beginPath();
  places.forEach(([x, y], i) => {
    const place = camera.to_screen(x, y);
    if (i === 0) pen.moveTo(...place);
    else pen.lineTo(...place);
  });
}

export function circle(pen: Pen, camera: Camera, x_m: number, y_m: number, r_m: number): void {
  const [x, y] = camera.to_screen(x_m, y_m);
  pen.beginPath();
  pen.arc(x, y, r_m * camera.px_per_m, 0, 2 * Math.PI);
}
