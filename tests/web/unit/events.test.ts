import { kEventKinds, type Event } from '@/wire/words';
import { listed, matches, type EventFilter } from '@/operate/event_filter';
import { group_of, kGroups, words_of_event } from '@/operate/words_of_event';

function event(kind: (typeof kEventKinds)[number], more: Partial<Event> = {}): Event {
  return {
    x_m: 0, y_m: 0, distance_to_target_m: 0, mean_distance_to_target_m: 0, mean_speed_mps: 0,
    joystick_x: 0, joystick_y: 0, tick: 0n, score_ticks: 0n, number: 0, left: 0, other: 0, robot: 0,
    other_robot: 0, detail: 0, word: '', kind: kEventKinds.indexOf(kind), ...more,
  };
}

test('every kind of event has a sentence and a group', () => {
  for (const kind of kEventKinds) {
    expect(words_of_event(event(kind))).not.toBe('');
    expect(kGroups).toContain(group_of(event(kind)));
  }
});

test('the kinds are in the order of the wire', () => {
  expect(kEventKinds).toHaveLength(30);
  expect(kEventKinds[13]).toBe('disabled');
  expect(kEventKinds[29]).toBe('operator');
});

test('a kind that nobody knows is told, not hidden', () => {
  expect(words_of_event({ ...event('created'), kind: 99 })).toContain('99');
});

test('a sentence names who and what', () => {
  expect(words_of_event(event('revived', { robot: 3, other_robot: 5 }))).toBe('Robot 3 is revived by robot 5');
  expect(words_of_event(event('stored', { robot: 3, number: 8, left: 2 }))).toBe('Robot 3 stores mine 8; 2 left');
});

test('the filter looks at group, robot and words', () => {
  const logged = { index: 0, event: event('revived', { robot: 3, other_robot: 5 }) };
  expect(matches(logged, ['robots'], null, 'revived')).toBe(true);
  expect(matches(logged, ['mines'], null, '')).toBe(false);
  expect(matches(logged, kGroups, 5, '')).toBe(true);
  expect(matches(logged, kGroups, 4, '')).toBe(false);
});

test('checkpoints are told of runs that guard a target alone', () => {
  const log = [event('created'), event('checkpoint')].map((one, index) => ({ index, event: one }));
  const filter = { groups: kGroups, words: '', checkpoints: false } as unknown as EventFilter;
  expect(listed(log, filter).map((one) => one.index)).toEqual([0]);
  expect(listed(log, { ...filter, checkpoints: true })).toHaveLength(2);
});
