import type { Scene } from '@/api/types';
import { change, kMostTasks, name_of, type Draft, type DraftTask } from '@/plan/draft';
import { reach_of } from '@/plan/reach';

export interface Problem {
  level: 'error' | 'warning';
  /** Whose it is; the whole description's when absent. */
  task?: number;
  what: string;
  why: string;
  fix?: { label: string; apply: (draft: Draft) => Draft };
}

const kClear_m = 0.5;
const kTooNear_m = 0.3;
const kSame_m = 0.1;

/** Everything that is wrong or odd with a description, worst first. */
export function problems_of(draft: Draft, scene: Scene | null): Problem[] {
  const found = [...whole(draft), ...preferences(draft)];
  draft.tasks.forEach((task, i) => {
    found.push(...contradictions(draft, task, i, scene));
    if (scene) found.push(...places(task, i, scene));
  });
  return found.sort((a, b) => Number(b.level === 'error') - Number(a.level === 'error'));
}

function whole(draft: Draft): Problem[] {
  if (!draft.map) {
    return [{ level: 'error', what: 'No map is chosen', why: 'Tasks have their places on a map.' }];
  }
  if (draft.tasks.length === 0) {
    return [{ level: 'error', what: 'There is no task', why: 'A plan needs at least one task to do.' }];
  }
  if (draft.tasks.length > kMostTasks) {
    const surplus = draft.tasks.length - kMostTasks;
    return [{
      level: 'error', what: `${surplus} tasks too many`, why: `A mission has at most ${kMostTasks}.`,
      fix: { label: 'Keep the first ones', apply: (d) => ({ ...d, tasks: d.tasks.slice(0, kMostTasks) }) },
    }];
  }
  return [];
}

const kRanges = [
  ['max_velocity_mps', 'Max velocity', 0.1, 1, ' m/s'],
  ['aggressiveness', 'Aggressiveness', 0.1, 1, ''],
  ['robots', 'Number of robots', 1, 10, ''],
] as const;

function preferences({ preferences: now }: Draft): Problem[] {
  return kRanges.flatMap(([key, name, low, high, unit]): Problem[] => {
    const value = now[key];
    if (value === null || (value >= low && value <= high)) return [];
    const right = Math.min(Math.max(Number.isFinite(value) ? value : low, low), high);
    return [{
      level: 'error', what: `${name} is ${value}${unit}`,
      why: `The wizard takes ${low} to ${high}${unit}.`,
      fix: { label: `Set it to ${right}${unit}`, apply: (draft) => change.prefer(draft, { [key]: right }) },
    }];
  });
}

function called(task: DraftTask, index: number): string {
  return `Task ${index + 1} (${name_of(task.task)})`;
}

function contradictions(draft: Draft, task: DraftTask, index: number, scene: Scene | null): Problem[] {
  const found: Problem[] = [];
  const say = (what: string, why: string, label: string, apply: (draft: Draft) => Draft) =>
    found.push({ level: 'warning', task: task.id, what: `${called(task, index)} ${what}`, why, fix: { label, apply } });
  if (draft.preferences.enemy && task.handles_enemy === false) {
    say('does not consider the enemy', 'An enemy is expected in this mission.', 'Consider it',
      (d) => change.set(d, task.id, { handles_enemy: true }));
  }
  if (task.environment === 'Outdoor' && scene && room_at(scene, task)) {
    say('is outdoor but in a room', `Its place is inside "${room_at(scene, task)}".`, 'Make it indoor',
      (d) => change.set(d, task.id, { environment: 'Indoor' }));
  }
  if (task.environment === 'Indoor' && scene && scene.rooms.length === 0) {
    say('is indoor but the map has no room', `"${scene.name}" is open ground.`, 'Make it outdoor',
      (d) => change.set(d, task.id, { environment: 'Outdoor' }));
  }
  const twin = draft.tasks.slice(0, index).findIndex(
    (one) => one.task === task.task && Math.hypot(one.x - task.x, one.y - task.y) < kSame_m,
  );
  if (twin >= 0) {
    say(`is the same as task ${twin + 1}`, 'The same would be done twice at one place.', 'Remove it',
      (d) => change.remove(d, task.id));
  }
  return found;
}

function places(task: DraftTask, index: number, scene: Scene): Problem[] {
  const { shift } = scene;
  const at: [number, number] = [task.x + shift.x, task.y + shift.y];
  const fix_to = (label: string, x: number, y: number) => ({
    label, apply: (draft: Draft) => change.move(draft, task.id, x - shift.x, y - shift.y),
  });
  const say = (level: Problem['level'], what: string, why: string, fix: Problem['fix']): Problem[] => [
    { level, task: task.id, what: `${called(task, index)} ${what}`, why, ...(fix ? { fix } : {}) },
  ];
  if (task.x < 0 || task.y < 0 || task.x > scene.width_m || task.y > scene.height_m) {
    const inside = (value: number, most: number) => Math.min(Math.max(value, kClear_m), most - kClear_m);
    return say('error', 'is outside the map', `The map is ${scene.width_m} m by ${scene.height_m} m.`,
      fix_to('Move it inside', inside(task.x, scene.width_m) + shift.x, inside(task.y, scene.height_m) + shift.y));
  }
  const disc = scene.discs.find(([x, y, r]) => Math.hypot(at[0] - x, at[1] - y) < r);
  if (disc) {
    return say('error', 'is inside an obstacle', 'No robot can come to it.',
      fix_to('Move it beside', ...pushed_off([disc[0], disc[1]], at, disc[2] + kClear_m)));
  }
  const wall = nearest_on_walls(scene, at);
  if (wall && wall.distance < kTooNear_m) {
    return say('warning', 'is very near to a wall', 'A robot has to keep a margin from walls and may not reach it.',
      fix_to('Move it off the wall', ...pushed_off(wall.place, at, kClear_m)));
  }
  const reach = reach_of(scene);
  if (reach && !reach.reaches(...at)) {
    const nearest = reach.nearest(...at);
    return say('warning', 'seems out of reach', 'No way was found to it from the start place.',
      nearest ? fix_to('Move it to the nearest place in reach', ...nearest) : undefined);
  }
  return [];
}

/** `distance` from `from`, on the side where `at` is. */
function pushed_off(from: [number, number], at: [number, number], distance: number): [number, number] {
  const [x, y] = [at[0] - from[0], at[1] - from[1]];
  const length = Math.hypot(x, y);
  if (length < 1e-6) return [from[0] + distance, from[1]];
  return [from[0] + (x / length) * distance, from[1] + (y / length) * distance];
}

function nearest_on_walls(scene: Scene, at: [number, number]) {
  let best: { place: [number, number]; distance: number } | null = null;
  for (const wall of scene.walls) {
    const place = nearest_on(wall, at);
    const distance = Math.hypot(at[0] - place[0], at[1] - place[1]);
    if (!best || distance < best.distance) best = { place, distance };
  }
  return best;
}

function nearest_on([ax, ay, bx, by]: [number, number, number, number], at: [number, number]): [number, number] {
  const [x, y] = [bx - ax, by - ay];
  const square = x * x + y * y || 1;
  const share = Math.min(Math.max(((at[0] - ax) * x + (at[1] - ay) * y) / square, 0), 1);
  return [ax + share * x, ay + share * y];
}

/** The name of the room that a task lies in. */
export function room_at(scene: Scene, task: { x: number; y: number }): string | undefined {
  const [x, y] = [task.x + scene.shift.x, task.y + scene.shift.y];
  return scene.rooms.find(({ outline }) => is_inside(outline, x, y))?.name;
}

function is_inside(outline: [number, number][], x: number, y: number): boolean {
  let inside = false;
  outline.forEach(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length]!;
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  });
  return inside;
}
