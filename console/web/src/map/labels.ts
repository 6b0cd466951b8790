import type { Place, Scene } from '@/api/types';
import type { Camera } from '@/map/camera';

export interface Label {
  text: string;
  /** Its middle, and the line that it stands on. */
  x: number;
  y: number;
}

const kLetter_px = 6.8;
const kAbove_px = 11;
const kBelow_px = 3;
const kUnderPoint_px = 18;
const kUnderMark_px = 22;

/** The names on a map. A point whose name would lie on another name goes without. */
export function labels_of(camera: Camera, scene: Scene): Label[] {
  const at = (text: string, [x_m, y_m]: Place, under_px = 0): Label => {
    const [x, y] = camera.to_screen(x_m, y_m);
    return { text, x, y: y + under_px };
  };
  const labels = scene.rooms.map((room) => at(room.name, middle(room.outline)));
  const { start, target, base } = scene;
  if (base) labels.push(at('Base', [base.x, base.y]));
  if (start) labels.push(at('Start', [start.x, start.y], kUnderMark_px));
  if (target) labels.push(at('Target', [target.x, target.y], kUnderMark_px));
  for (const point of scene.points) {
    const label = at(point.name, [point.x, point.y], kUnderPoint_px);
    if (!labels.some((other) => overlap(label, other))) labels.push(label);
  }
  return labels;
}

function overlap(a: Label, b: Label): boolean {
  const wide = (kLetter_px * (a.text.length + b.text.length)) / 2;
  return Math.abs(a.x - b.x) < wide && Math.abs(a.y - b.y) < kAbove_px + kBelow_px;
}

function middle(outline: Place[]): Place {
  const xs = outline.map(([x]) => x);
  const ys = outline.map(([, y]) => y);
  return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
}
