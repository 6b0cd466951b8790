import { LiveRun } from '@/live/live_run';
import type { Event } from '@/wire/words';

const kEvent = { tick: 1n, kind: 13, robot: 4, number: 0 } as Event;

function run_at(clock: { ms: number }) {
  return new LiveRun('ws://nowhere', () => clock.ms);
}

function telemetry(tick: bigint, names: string[]) {
  return {
    tick, robot: 2, decisions: tick, duplicates: 0n, rejected: 0n, learner: 'lm', role: '', state: '',
    situation: 'AllClear', shares: names.map((name, i) => ({ name, gain: i + 1, push_x: 0, push_y: 0 })),
  };
}

test('an event that came already is not taken again', () => {
  const run = run_at({ ms: 0 });
  run.take('/tacit/events', { first: 0n, events: [kEvent, kEvent] });
  run.take('/tacit/events', { first: 1n, events: [kEvent, kEvent] });
  expect(run.events.map((one) => one.index)).toEqual([0, 1, 2]);
  expect(run.missed_events).toBe(0);
});

test('a gap in the event log is counted', () => {
  const run = run_at({ ms: 0 });
  run.take('/tacit/events', { first: 0n, events: [kEvent] });
  run.take('/tacit/events', { first: 5n, events: [kEvent] });
  expect(run.missed_events).toBe(4);
});

test('a robot that stands still makes no trail', () => {
  const run = run_at({ ms: 0 });
  for (const tick of [1n, 2n, 3n]) {
    run.take('/tacit/world_view', {
      time_s: Number(tick) / 10, tick, robots: [{ robot: 1, x_m: 2, y_m: 3, present: 1 }],
      enemies: [], mines: [], objects: [],
    });
  }
  expect(run.trails.get(1)?.length).toBe(1);
});

test('the rate of an agent is what came, by the clock', () => {
  const clock = { ms: 0 };
  const run = run_at(clock);
  for (let i = 0; i < 11; ++i) {
    clock.ms = 100 * i;
    run.take('/tacit/robot_2/telemetry', telemetry(BigInt(i + 1), ['Noise']));
  }
  expect(run.health()[0]?.rate_hz).toBeCloseTo(10);
});

test('samples keep the gains of each assemblage under their own names', () => {
  const run = run_at({ ms: 0 });
  run.take('/tacit/robot_2/telemetry', telemetry(1n, ['Noise']));
  run.take('/tacit/robot_2/telemetry', telemetry(2n, ['MoveTo', 'Noise']));
  expect(run.samples(2).map((one) => one.names)).toEqual([['Noise'], ['MoveTo', 'Noise']]);
  expect([...run.samples(2)[1]!.gains]).toEqual([1, 2]);
});
