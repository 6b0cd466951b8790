import { address_of, route_of } from '@/app/route';
import { Jump } from '@/live/jump';
import { LiveRun } from '@/live/live_run';
import { Seeker } from '@/live/seeker';
import { bookmarks_of, neighbour } from '@/replay/bookmarks';
import type { Event } from '@/wire/words';

const kKinds = { hit: 2, checkpoint: 7, taken: 10 };

function event(tick: number, kind: keyof typeof kKinds) {
  return { tick: BigInt(tick), kind: kKinds[kind], robot: 1, number: 0 } as Event;
}

function view(tick: number) {
  return {
    time_s: tick / 10, tick: BigInt(tick), robots: [{ robot: 1, x_m: tick, y_m: 0, present: 1 }],
    enemies: [], mines: [], objects: [],
  };
}

function recording() {
  return new LiveRun('ws://nowhere', () => 0, true);
}

test('the address holds run and moment', () => {
  expect(route_of(address_of('replay', 'a b', 12.34))).toEqual({ view: 'replay', run: 'a b', time_s: 12.3 });
  expect(route_of('#/replay/r1')).toEqual({ view: 'replay', run: 'r1', time_s: null });
  for (const bad of ['', 'x', '-3', 'Infinity']) expect(route_of(`#/replay/r1?t=${bad}`).time_s).toBeNull();
  expect(route_of('#/results/%E0%A4%A').run).toBe('%E0%A4%A');
});

test('a jump is done when the clock says so', () => {
  const back = new Jump(10, 9);
  expect([10, 10.4, 9, 9.2].map((time_s) => back.is_done_at(time_s))).toEqual([false, false, true, true]);
  const on = new Jump(10, 20);
  expect([10, 19.9, 20, 20.1].map((time_s) => on.is_done_at(time_s))).toEqual([false, false, true, true]);
  back.end();
  on.end();
});

test('a recording that goes back forgets trails and events, and keeps what was heard', () => {
  const run = recording();
  for (const tick of [1, 2, 3]) run.take('/tacit/world_view', view(tick), tick / 10);
  run.take('/tacit/events', { first: 4n, events: [event(3, 'taken')] }, 0.3);
  run.take('/tacit/world_view', view(1), 0.1);
  expect(run.trails.get(1)?.length).toBe(1);
  expect(run.events).toHaveLength(0);
  expect(run.log.map((one) => one.index)).toEqual([4]);
  run.take('/tacit/events', { first: 2n, events: [event(2, 'taken'), event(2, 'hit')] }, 0.2);
  run.take('/tacit/events', { first: 4n, events: [event(3, 'taken')] }, 0.3);
  expect(run.log.map((one) => one.index)).toEqual([2, 3, 4]);
  expect(run.missed_events).toBe(0);
});

test('a paused recording is not stale, and is never over', () => {
  const run = recording();
  run.take('/tacit/status', { phase: 3 });
  run.take_playing({ start_s: 0, end_s: 60, time_s: 12, playing: false, speed: 1 });
  expect([run.over, run.paused, run.time_s]).toEqual([false, true, 12]);
});

test('bookmarks are moments, without checkpoints', () => {
  const log = [event(1, 'taken'), event(5, 'checkpoint'), event(9, 'taken'), event(9, 'hit')];
  const marks = bookmarks_of(log.map((one, index) => ({ index, event: one })), 0.5);
  expect(marks).toEqual([{ time_s: 0.5, grave: false }, { time_s: 4.5, grave: true }]);
  expect(neighbour(marks, 0.5, 1)?.time_s).toBe(4.5);
  expect(neighbour(marks, 4.5, -1)?.time_s).toBe(0.5);
  expect(neighbour(marks, 5, -1, 1.5)?.time_s).toBe(0.5);
  expect(neighbour(marks, 4.5, 1)).toBeUndefined();
});

test('of many jumps that are asked for, the newest is made', async () => {
  const made: number[] = [];
  let go = () => {};
  const seeker = new Seeker(
    (time_s) => {
      made.push(time_s);
      return new Promise((done) => (go = done));
    },
    () => {},
    () => {},
  );
  for (const time_s of [1, 2, 3]) seeker.to(time_s);
  expect(seeker.goal_s).toBe(3);
  go();
  await Promise.resolve();
  await Promise.resolve();
  go();
  await vi.waitFor(() => expect(seeker.goal_s).toBeNull());
  expect(made).toEqual([1, 3]);
});
