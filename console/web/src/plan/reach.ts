import type { Scene } from '@/api/types';

const kStep_m = 0.5;
const kMostColumns = 240;

type Segment = [number, number, number, number];

/** Where one can get to from a map's start place, on a grid: an estimate to warn by, not to steer by. */
export interface Reach {
  /** World frame. */
  reaches(x: number, y: number): boolean;
  /** The nearest place that can be reached; nothing when there is none. */
  nearest(x: number, y: number): [number, number] | null;
}

const known = new WeakMap<Scene, Reach | null>();

/** Nothing when the map has no start place. */
export function reach_of(scene: Scene): Reach | null {
  if (!known.has(scene)) known.set(scene, scene.start ? flood(scene, scene.start) : null);
  return known.get(scene) ?? null;
}

function flood(scene: Scene, start: { x: number; y: number }): Reach {
  const step = Math.max(kStep_m, Math.max(scene.width_m, scene.height_m) / kMostColumns);
  const columns = Math.ceil(scene.width_m / step);
  const rows = Math.ceil(scene.height_m / step);
  const reached = new Uint8Array(columns * rows);
  const place_of = (cell: number): [number, number] => [
    scene.shift.x + ((cell % columns) + 0.5) * step,
    scene.shift.y + (Math.floor(cell / columns) + 0.5) * step,
  ];
  const cell_of = (x: number, y: number) => {
    const column = Math.floor((x - scene.shift.x) / step);
    const row = Math.floor((y - scene.shift.y) / step);
    return column < 0 || row < 0 || column >= columns || row >= rows ? -1 : row * columns + column;
  };
  const open = [cell_of(start.x, start.y)].filter((cell) => cell >= 0);
  for (const cell of open) reached[cell] = 1;
  while (open.length > 0) {
    const cell = open.pop()!;
    for (const next of neighbours(cell, columns, rows)) {
      if (reached[next] || is_barred(scene, [...place_of(cell), ...place_of(next)])) continue;
      reached[next] = 1;
      open.push(next);
    }
  }
  return {
    reaches: (x, y) => reached[cell_of(x, y)] === 1,
    nearest: (x, y) => nearest_of(reached, place_of, x, y),
  };
}

function neighbours(cell: number, columns: number, rows: number): number[] {
  const column = cell % columns;
  const row = Math.floor(cell / columns);
  const next: number[] = [];
  if (column > 0) next.push(cell - 1);
  if (column + 1 < columns) next.push(cell + 1);
  if (row > 0) next.push(cell - columns);
  if (row + 1 < rows) next.push(cell + columns);
  return next;
}

function is_barred(scene: Scene, way: Segment): boolean {
  const [, , x, y] = way;
  return (
    scene.discs.some(([cx, cy, r]) => Math.hypot(x - cx, y - cy) < r) ||
    scene.walls.some((wall) => cross(way, wall))
  );
}

function side(ax: number, ay: number, bx: number, by: number, x: number, y: number): number {
  return Math.sign((bx - ax) * (y - ay) - (by - ay) * (x - ax));
}

function cross([ax, ay, bx, by]: Segment, [cx, cy, dx, dy]: Segment): boolean {
  return (
    side(ax, ay, bx, by, cx, cy) !== side(ax, ay, bx, by, dx, dy) &&
    side(cx, cy, dx, dy, ax, ay) !== side(cx, cy, dx, dy, bx, by)
  );
}

function nearest_of(
  reached: Uint8Array, place_of: (cell: number) => [number, number], x: number, y: number,
): [number, number] | null {
  let best: [number, number] | null = null;
  let least = Infinity;
  reached.forEach((is, cell) => {
    if (!is) return;
    const place = place_of(cell);
    const distance = Math.hypot(place[0] - x, place[1] - y);
    if (distance < least) [least, best] = [distance, place];
  });
  return best;
}
