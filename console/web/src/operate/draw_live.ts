import type { LiveRun } from '@/live/live_run';
import type { Trail } from '@/live/trail';
import type { Camera } from '@/map/camera';
import { circle } from '@/map/draw_scene';
import { series_colour, type Palette } from '@/map/palette';
import { kind_of } from '@/operate/glyphs';

type Pen = CanvasRenderingContext2D;

const kFades = 4;
const kMostPush_px = 80;
const kPushUnit_px = 40;

export interface LiveDrawing {
  selected: number | null;
  trails: boolean;
  trail_s: number;
  vectors: boolean;
  sensors: boolean;
  sensor_m: number;
}

/** Trails, sensor ranges, and the selected robot's pushes. */
export function draw_live(pen: Pen, camera: Camera, run: LiveRun, look: LiveDrawing, colours: Palette): void {
  if (look.sensors) draw_sensors(pen, camera, run, look, colours);
  if (look.trails) draw_trails(pen, camera, run, look, colours);
  if (look.vectors && look.selected !== null) draw_pushes(pen, camera, run, look.selected, colours);
}

const kTrailColours = {
  forager: 'c2', soldier: 'c1', mechanic: 'c3', robot: 'c1', hostile: 'c6',
} as const;

function draw_trails(pen: Pen, camera: Camera, run: LiveRun, look: LiveDrawing, colours: Palette): void {
  const now_s = run.view?.time_s ?? 0;
  pen.lineCap = 'round';
  for (const [robot, trail] of run.trails) {
    const seen = run.robots.get(robot);
    if (!seen || trail.length < 2) continue;
    pen.strokeStyle = colours[kTrailColours[kind_of(seen, run.telemetry(robot))]];
    pen.lineWidth = robot === look.selected ? 3 : 1.5;
    draw_trail(pen, camera, trail, now_s, look.trail_s);
  }
  pen.globalAlpha = 1;
}

/** In a few parts, the older the fainter. */
function draw_trail(pen: Pen, camera: Camera, trail: Trail, now_s: number, length_s: number): void {
  let part = -1;
  let open = false;
  for (let i = 0; i < trail.length; ++i) {
    const [x_m, y_m, time_s] = trail.at(i);
    const age = (now_s - time_s) / length_s;
    if (age > 1) continue;
    const [x, y] = camera.to_screen(x_m, y_m);
    const now_part = Math.floor((1 - age) * (kFades - 0.001));
    if (open) pen.lineTo(x, y);
    if (now_part === part && open) continue;
    if (open) pen.stroke();
    part = now_part;
    pen.globalAlpha = 0.15 + (0.65 * (part + 1)) / kFades;
    pen.beginPath();
    pen.moveTo(x, y);
    open = true;
  }
  if (open) pen.stroke();
}

function draw_sensors(pen: Pen, camera: Camera, run: LiveRun, look: LiveDrawing, colours: Palette): void {
  pen.strokeStyle = colours.faint;
  pen.lineWidth = 1;
  pen.setLineDash([4, 4]);
  for (const robot of run.robots.values()) {
    if (look.selected !== null && robot.robot !== look.selected) continue;
    circle(pen, camera, robot.x_m, robot.y_m, look.sensor_m);
    pen.stroke();
  }
  pen.setLineDash([]);
}

/** One arrow for each motor schema, as long as gain × push, and a dark one for the sum. */
function draw_pushes(pen: Pen, camera: Camera, run: LiveRun, selected: number, colours: Palette): void {
  const robot = run.robots.get(selected);
  const telemetry = run.telemetry(selected);
  if (!robot || !telemetry) return;
  const from = camera.to_screen(robot.x_m, robot.y_m);
  let sum: [number, number] = [0, 0];
  telemetry.shares.forEach((share, i) => {
    const ahead = share.gain * share.push_x;
    const left = share.gain * share.push_y;
    const push: [number, number] = [
      ahead * robot.heading_cos - left * robot.heading_sin,
      ahead * robot.heading_sin + left * robot.heading_cos,
    ];
    sum = [sum[0] + push[0], sum[1] + push[1]];
    arrow(pen, from, push, series_colour(i), 2.5);
  });
  arrow(pen, from, sum, colours.push, 4);
}

function arrow(pen: Pen, from: [number, number], push: [number, number], colour: string, width: number): void {
  const strength = Math.hypot(...push);
  if (strength < 1e-3) return;
  const length = Math.min(strength * kPushUnit_px, kMostPush_px) + 12;
  const angle = Math.atan2(-push[1], push[0]);
  pen.save();
  pen.translate(...from);
  pen.rotate(angle);
  pen.strokeStyle = colour;
  pen.fillStyle = colour;
  pen.lineWidth = width;
  pen.beginPath();
  pen.moveTo(12, 0);
  pen.lineTo(length - 5, 0);
  pen.stroke();
  pen.beginPath();
  pen.moveTo(length + 3, 0);
  pen.lineTo(length - 7, 4 + width / 2);
  pen.lineTo(length - 7, -4 - width / 2);
  pen.fill();
  pen.restore();
}
