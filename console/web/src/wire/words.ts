/** What comes over the socket: the structures of `idl/wire/team.idl`, unpacked. */

/** As in a percept, by number. */
export const kColours = [
  'white', 'blue', 'red', 'yellow', 'orange', 'purple', 'green', 'black', 'sea green', 'brown',
  'light blue', 'grey',
] as const;

export const kPhases = ['gathering', 'running', 'paused', 'ended', 'stopped'] as const;
export type Phase = (typeof kPhases)[number];

export const kEnemyKinds = ['normal', 'decoy', 'hunter'] as const;

export interface RunStatus {
  wall_s: number;
  first_tick_s: number;
  tick: bigint;
  last_tick: bigint;
  events: bigint;
  resent: number;
  rejected: number;
  robots: number;
  present: number;
  phase: number;
  repeatable: number;
}

export const kEventKinds = [
  'created', 'intercepted', 'hit', 'collision', 'lost', 'back', 'late', 'checkpoint', 'ended',
  'retreated', 'taken', 'dropped', 'stored', 'disabled', 'revived', 'over', 'begun',
  'operation begun', 'object taken', 'object dropped', 'object stored', 'object tested', 'marked',
  'entered', 'reached', 'signalled', 'alerted', 'exposed', 'finished', 'operator',
] as const;
export type EventKind = (typeof kEventKinds)[number];

export interface Event {
  x_m: number;
  y_m: number;
  distance_to_target_m: number;
  mean_distance_to_target_m: number;
  mean_speed_mps: number;
  joystick_x: number;
  joystick_y: number;
  tick: bigint;
  score_ticks: bigint;
  number: number;
  left: number;
  other: number;
  robot: number;
  other_robot: number;
  kind: number;
  detail: number;
  word: string;
}

export interface EventBatch {
  first: bigint;
  events: Event[];
}

export interface ViewedRobot {
  x_m: number;
  y_m: number;
  heading_cos: number;
  heading_sin: number;
  velocity_x_mps: number;
  velocity_y_mps: number;
  robot: number;
  present: number;
  able: number;
  holding: number;
  colour: number;
}

export interface ViewedEnemy {
  x_m: number;
  y_m: number;
  enemy: number;
  kind: number;
}

export interface ViewedMine {
  x_m: number;
  y_m: number;
  mine: number;
}

export interface ViewedObject {
  x_m: number;
  y_m: number;
  radius_m: number;
  number: number;
  colour: number;
}

export interface WorldView {
  time_s: number;
  tick: bigint;
  robots: ViewedRobot[];
  enemies: ViewedEnemy[];
  mines: ViewedMine[];
  objects: ViewedObject[];
}

/** `push` is the motor schema's own output before weighting, in the robot's frame: x ahead, y left. */
export interface SchemaShare {
  gain: number;
  push_x: number;
  push_y: number;
  name: string;
}

export interface Telemetry {
  tick: bigint;
  decisions: bigint;
  duplicates: bigint;
  rejected: bigint;
  robot: number;
  learner: string;
  situation: string;
  role: string;
  state: string;
  shares: SchemaShare[];
}
