import { kEnemyKinds, kEventKinds, type Event, type EventKind } from '@/wire/words';

export type Group = 'robots' | 'enemies' | 'mines' | 'mission' | 'run';
export const kGroups: Group[] = ['robots', 'enemies', 'mines', 'mission', 'run'];

const kGroupOf: Record<EventKind, Group> = {
  created: 'enemies', intercepted: 'enemies', hit: 'enemies', retreated: 'enemies',
  collision: 'robots', lost: 'robots', back: 'robots', late: 'robots', disabled: 'robots',
  revived: 'robots', taken: 'mines', dropped: 'mines', stored: 'mines',
  'operation begun': 'mission', 'object taken': 'mission', 'object dropped': 'mission',
  'object stored': 'mission', 'object tested': 'mission', marked: 'mission', entered: 'mission',
  reached: 'mission', signalled: 'mission', alerted: 'mission', exposed: 'mission',
  finished: 'mission', operator: 'run', checkpoint: 'run', ended: 'run', over: 'run', begun: 'run',
};

export function group_of(event: Event): Group {
  const kind = kEventKinds[event.kind];
  return kind ? kGroupOf[kind] : 'run';
}

/** A checkpoint tells of enemies and a target: of a run that guards one. */
export function is_checkpoint(event: Event): boolean {
  return kEventKinds[event.kind] === 'checkpoint';
}

const kBumped = ['an obstacle', 'a wall', 'robot', 'enemy'];
const kEnds = ['accomplished', 'the team was lost', 'out of time'];
const kWhere = ['the open', 'room', 'hallway'];
const kOperator = ['steers', 'lets go of', 'says "proceed" to', 'lets leave out a goal:'];

const from_target = (event: Event) => `${event.distance_to_target_m.toFixed(1)} m from the target`;
const kinded = (event: Event) => {
  const kind = kEnemyKinds[event.detail];
  return kind && kind !== 'normal' ? `Enemy ${event.number} (${kind})` : `Enemy ${event.number}`;
};
const who = (event: Event) => `Robot ${event.robot}`;

const kSentences: Record<EventKind, (event: Event) => string> = {
  created: (e) => `${kinded(e)} appears at ${e.x_m.toFixed(1)}, ${e.y_m.toFixed(1)} m`,
  intercepted: (e) => `${who(e)} intercepts ${kinded(e).toLowerCase()}, ${from_target(e)}`,
  hit: (e) => `Enemy ${e.number} reaches the target`,
  retreated: (e) => `Enemy ${e.number} retreats`,
  collision: (e) =>
    `${who(e)} bumps into ${kBumped[e.detail] ?? 'something'}${e.detail > 1 ? ` ${e.number}` : ''}`,
  lost: (e) => `${who(e)} is lost: its process does not answer`,
  back: (e) => `${who(e)} is back`,
  late: (e) => `${who(e)} was late and stood still`,
  disabled: (e) => `${who(e)} is disabled by ${e.detail === 1 ? 'an enemy' : 'mud'}`,
  revived: (e) => `${who(e)} is revived by robot ${e.other_robot}`,
  taken: (e) => `${who(e)} takes mine ${e.number}`,
  dropped: (e) => `${who(e)} drops mine ${e.number}`,
  stored: (e) => `${who(e)} stores mine ${e.number}; ${e.left} left`,
  begun: (e) => `The mission begins${e.left > 0 ? `: ${e.left} mines to store` : ''}`,
  over: (e) => `The mission is over: ${kEnds[e.detail] ?? 'ended'}`,
  checkpoint: (e) =>
    `${e.number} enemies alive; robots ${e.mean_distance_to_target_m.toFixed(1)} m from the target on average`,
  ended: () => 'The run has ended',
  'operation begun': (e) => `The operation begins: ${e.number} robots, ${e.other} extra`,
  'object taken': (e) => `${who(e)} takes object ${e.number}`,
  'object dropped': (e) => `${who(e)} drops object ${e.number}`,
  'object stored': (e) => `${who(e)} puts object ${e.number} into container ${e.other}`,
  'object tested': (e) =>
    `${who(e)} tests object ${e.number}: ${e.detail === 2 ? 'dangerous' : 'harmless'}`,
  marked: (e) => `${who(e)} ${e.detail ? 'marks' : 'unmarks'} doorway ${e.number}`,
  entered: (e) =>
    `${who(e)} enters ${kWhere[e.detail] ?? 'a place'}${e.detail > 0 ? ` ${e.number}` : ''}`,
  reached: (e) => `${who(e)} reaches point ${e.number}`,
  signalled: (e) => `${who(e)} calls "${e.word}"; ${e.other} heard it`,
  alerted: (e) => `${who(e)} alerts the operator: "${e.word}"`,
  exposed: (e) =>
    `${who(e)} is ${e.detail ? 'seen' : 'no longer seen'} by enemy robot ${e.other_robot}`,
  finished: (e) => `${who(e)} has nothing more to do`,
  operator: (e) =>
    `The operator ${kOperator[e.detail] ?? 'speaks to'} ${e.robot ? `robot ${e.robot}` : 'all robots'}`,
};

/** An event as a sentence. */
export function words_of_event(event: Event): string {
  const kind = kEventKinds[event.kind];
  return kind ? kSentences[kind](event) : `Event of unknown kind ${event.kind}`;
}

/** What a person should look at. */
export function is_grave(event: Event): boolean {
  const kind = kEventKinds[event.kind];
  return kind === 'lost' || kind === 'disabled' || kind === 'hit' || kind === 'exposed';
}
