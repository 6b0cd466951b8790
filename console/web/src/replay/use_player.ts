import { useEffect, useReducer, useRef } from 'react';

import { words_of } from '@/api/client';
import type { LiveRun } from '@/live/live_run';
import { Seeker } from '@/live/seeker';
import { listed, type EventFilter } from '@/operate/event_filter';
import { useCalls } from '@/operate/use_live';
import { bookmarks_of, neighbour } from '@/replay/bookmarks';

/** Times the run's own time. */
export const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16, 64, 256];
const kTick_s = 0.1;
/** Where "the event before" is the one before the last while it plays. */
const kNear_s = 1.5;

export interface Player {
  error: string;
  /** Where it stands, or is going to. */
  time_s: () => number;
  at_end: () => boolean;
  speed: () => number;
  toggle: () => void;
  step: () => void;
  faster: () => void;
  slower: () => void;
  set_speed: (factor: number) => void;
  go: (time_s: number) => void;
  go_by: (seconds: number) => void;
  to_event: (by: -1 | 1) => void;
}

/** The controls of a recorded run. */
export function usePlayer(live: LiveRun, filter: EventFilter): Player {
  const { error, set_error, call } = useCalls(live);
  const [, draw] = useReducer((n: number) => n + 1, 0);
  const asked_speed = useRef<number | null>(null);
  const made = useRef<Seeker | null>(null);
  const seeker = (made.current ??= new Seeker(
    (time_s) => live.seek(time_s),
    draw,
    (thrown) => set_error(`"seek" was not done: ${words_of(thrown)}`),
  ));
  const ends = () => live.playing ?? { start_s: 0, end_s: 0 };
  const time_s = () => seeker.goal_s ?? live.time_s;
  const at_end = () => live.playing !== null && time_s() >= ends().end_s - 1e-3;
  const speed = () => asked_speed.current ?? live.playing?.speed ?? 1;
  const go = (to_s: number) => {
    const { start_s, end_s } = ends();
    seeker.to(Math.min(Math.max(to_s, start_s), end_s));
  };
  const set_speed = async (factor: number) => {
    asked_speed.current = factor;
    draw();
    if (!(await call('speed', { factor }))) asked_speed.current = null;
    draw();
  };
  const change = (by: number) => {
    const at = kSpeeds.findIndex((one) => one >= speed());
    const next = kSpeeds[at + by];
    if (next !== undefined) void set_speed(next);
  };
  return {
    error,
    time_s,
    at_end,
    speed,
    toggle: () => {
      if (live.paused && at_end()) go(ends().start_s);
      void call(live.paused ? 'resume' : 'pause');
    },
    step: () => void call('step', { ticks: Math.max(1, live.tick_s / kTick_s) }),
    faster: () => change(1),
    slower: () => change(-1),
    set_speed: (factor) => void set_speed(factor),
    go,
    go_by: (seconds) => go(time_s() + seconds),
    to_event: (by) => {
      const marks = bookmarks_of(listed(live.log, filter), live.tick_s);
      const near_s = live.paused ? 0 : kNear_s * Math.max(speed(), 1);
      const mark = neighbour(marks, time_s(), by, near_s);
      if (mark) go(mark.time_s);
    },
  };
}

const kWriteAfter_ms = 400;

/** Writes the moment into the address while it stands still, so that the address can be shared. */
export function useWrittenMoment(live: LiveRun, address: (time_s: number) => string): void {
  const { paused, time_s } = live;
  const known = live.playing !== null;
  useEffect(() => {
    if (!known || !paused) return;
    const timer = setTimeout(() => history.replaceState(null, '', address(time_s)), kWriteAfter_ms);
    return () => clearTimeout(timer);
    // `address` says the same each time.
    // eslint-disable-next-line react-hooks/exhaustive-deps
  }, [known, paused, time_s]);
}
