import { useRef, useState } from 'react';

import type { Run } from '@/api/types';
import { TwiceButton } from '@/app/parts';
import { clock } from '@/app/numbers';
import { address_of } from '@/app/route';
import type { LiveRun } from '@/live/live_run';
import { PlayAndSpeed } from '@/operate/PlayAndSpeed';
import { useCalls, useNews } from '@/operate/use_live';

/** Times real time; 0 is as fast as it goes. */
export const kSpeeds = [0.25, 0.5, 1, 2, 4, 8, 16, 0];

export interface RunControls {
  speed: number;
  error: string;
  toggle: () => void;
  step: () => void;
  faster: () => void;
  slower: () => void;
  set_speed: (factor: number) => void;
  stop: () => void;
}

export function useControls(live: LiveRun): RunControls {
  const [speed, note_speed] = useState(1);
  const { error, call } = useCalls(live);
  // What was asked for last counts, not what was answered: keys come faster than answers.
  const wanted = useRef(speed);
  const set_speed = async (factor: number) => {
    const before = wanted.current;
    wanted.current = factor;
    note_speed(factor);
    if (await call('speed', { factor })) return;
    wanted.current = before;
    note_speed(before);
  };
  const change = (by: number) => {
    const next = kSpeeds[kSpeeds.indexOf(wanted.current) + by];
    if (next !== undefined) void set_speed(next);
  };
  return {
    speed,
    error,
    toggle: () => void call(live.paused ? 'resume' : 'pause'),
    step: async () => {
      if (!live.paused && !(await call('pause'))) return;
      void call('step', { ticks: 1 });
    },
    faster: () => change(1),
    slower: () => change(-1),
    set_speed: (factor) => void set_speed(factor),
    stop: () => void call('stop'),
  };
}

/** Views come more often while ticks go by, but the last tick before a pause is told by the status alone. */
function newer(one: bigint, other: bigint): bigint {
  return one > other ? one : other;
}

export function Controls(props: { live: LiveRun; controls: RunControls; run: Run }) {
  const { live, controls, run } = props;
  useNews(live);
  const { status } = live;
  const { paused } = live;
  const dead = live.link !== 'open' || live.over;
  return (
    <header className="controls">
      <div className="run-title">
        <h1>{run.name || run.id}</h1>
        <span className={`phase ${live.phase ?? ''}`}>{live.phase ?? 'not heard yet'}</span>
      </div>
      <div className="row" role="group" aria-label="Run">
        <PlayAndSpeed
          paused={paused} dead={dead} toggle={controls.toggle} step={controls.step}
          speed={controls.speed} speeds={kSpeeds} set_speed={controls.set_speed}
        />
        <TwiceButton label="Stop" sure="Press again to stop" act={controls.stop} disabled={dead} />
      </div>
      <dl className="facts">
        <Fact name="Time" value={clock(live.view?.time_s ?? 0)} />
        <Fact name="Tick" value={status ? `${newer(live.view?.tick ?? 0n, status.tick)} of ${status.last_tick}` : '–'} />
        <Fact name="Real-time factor" value={paused || live.real_time_factor === 0 ? '–' : `${live.real_time_factor.toFixed(2)} ×`} />
        <Fact name="Robots" value={status ? `${status.present} of ${status.robots}` : '–'} />
        {live.over && (
          <a className="button" href={address_of('results', run.id)}>
            Results
          </a>
        )}
      </dl>
      {controls.error && (
        <p className="controls-error" role="alert">
          <span aria-hidden="true">⚠ </span>
          {controls.error}
        </p>
      )}
    </header>
  );
}

export function Fact({ name, value }: { name: string; value: string }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </div>
  );
}
