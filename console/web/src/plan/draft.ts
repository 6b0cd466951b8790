import type { PlacedTask, PlanRequest, TaskKind } from '@/api/types';

/** A task as it is being described. `id` is the page's own and stays while the task moves. */
export interface DraftTask extends PlacedTask {
  id: number;
}

export interface Preferences {
  /** Left to the cases when null. */
  robots: number | null;
  enemy: boolean;
  max_velocity_mps: number;
  aggressiveness: number;
  top: number;
}

/** What a person wants. Places are in the map's frame. */
export interface Draft {
  map: string;
  tasks: DraftTask[];
  preferences: Preferences;
}

export const kSafe: Preferences = {
  robots: null,
  enemy: false,
  max_velocity_mps: 0.5,
  aggressiveness: 0.3,
  top: 3,
};
export const kEmpty: Draft = { map: '', tasks: [], preferences: kSafe };
export const kMostTasks = 64;

export const kTasks: { kind: TaskKind; name: string; letter: string; help: string }[] = [
  { kind: 'biohazard', name: 'Biohazard', letter: 'B', help: 'Look through the building for a biohazard.' },
  { kind: 'eod', name: 'Explosives', letter: 'E', help: 'Bring explosive ordnance to where it belongs.' },
  { kind: 'waypoint', name: 'Waypoint', letter: 'W', help: 'Go to this place.' },
  { kind: 'hostage', name: 'Hostage', letter: 'H', help: 'Watch a hostage without being seen.' },
  { kind: 'rescue', name: 'Rescue', letter: 'R', help: 'Search for people and rescue them.' },
];

export function name_of(kind: TaskKind): string {
  return kTasks.find((task) => task.kind === kind)?.name ?? kind;
}

const kTenth = 10;
const rounded = (value: number) => Math.round(value * kTenth) / kTenth;

/** Each change gives a new draft; an id that is not there changes nothing. */
export const change = {
  add: (draft: Draft, kind: TaskKind, x: number, y: number): Draft => {
    const id = 1 + Math.max(0, ...draft.tasks.map((task) => task.id));
    return { ...draft, tasks: [...draft.tasks, { id, task: kind, x: rounded(x), y: rounded(y) }] };
  },
  set: (draft: Draft, id: number, fields: Partial<PlacedTask>): Draft => ({
    ...draft,
    tasks: draft.tasks.map((task) => (task.id === id ? without_open({ ...task, ...fields }) : task)),
  }),
  move: (draft: Draft, id: number, x: number, y: number): Draft =>
    change.set(draft, id, { x: rounded(x), y: rounded(y) }),
  remove: (draft: Draft, id: number): Draft => ({
    ...draft,
    tasks: draft.tasks.filter((task) => task.id !== id),
  }),
  duplicate: (draft: Draft, id: number): Draft => {
    const at = draft.tasks.findIndex((task) => task.id === id);
    const one = draft.tasks[at];
    if (!one) return draft;
    const copy = { ...one, id: 1 + Math.max(...draft.tasks.map((task) => task.id)), x: rounded(one.x + 1) };
    return { ...draft, tasks: inserted(draft.tasks, at + 1, copy) };
  },
  reorder: (draft: Draft, id: number, by: number): Draft => {
    const from = draft.tasks.findIndex((task) => task.id === id);
    const to = from + by;
    if (from < 0 || to < 0 || to >= draft.tasks.length) return draft;
    const tasks = [...draft.tasks];
    tasks.splice(to, 0, ...tasks.splice(from, 1));
    return { ...draft, tasks };
  },
  prefer: (draft: Draft, fields: Partial<Preferences>): Draft => ({
    ...draft,
    preferences: { ...draft.preferences, ...fields },
  }),
};

function inserted(tasks: DraftTask[], at: number, one: DraftTask): DraftTask[] {
  return [...tasks.slice(0, at), one, ...tasks.slice(at)];
}

/** A field that is left open is not there at all. */
function without_open(task: DraftTask): DraftTask {
  return Object.fromEntries(Object.entries(task).filter(([, value]) => value !== undefined)) as unknown as DraftTask;
}

export function request_of({ tasks, preferences }: Draft): PlanRequest {
  const { robots, ...rest } = preferences;
  return {
    ...rest,
    tasks: tasks.map(({ id: _, ...task }) => task),
    ...(robots === null ? {} : { robots }),
  };
}
