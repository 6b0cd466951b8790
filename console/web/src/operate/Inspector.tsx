import { useState } from 'react';

import { words_of } from '@/api/client';
import { clock, with_unit } from '@/app/numbers';
import type { LiveRun } from '@/live/live_run';
import { series_colour } from '@/map/palette';
import { GainsChart } from '@/operate/GainsChart';
import { useNews } from '@/operate/use_live';
import type { SchemaShare, Telemetry, ViewedRobot } from '@/wire/words';

interface Props {
  live: LiveRun;
  robot: number | null;
  select: (robot: number | null) => void;
  /** Whether the operator's word can be given. */
  operator: boolean;
}

export function Inspector({ live, robot, select, operator }: Props) {
  useNews(live);
  const all = live.view?.robots ?? [];
  const seen = robot === null ? undefined : live.robots.get(robot);
  return (
    <section className={`inspector ${live.stale ? 'stale' : ''}`} aria-label="Robot">
      <header className="panel-head">
        <h2>Robot</h2>
        <select
          aria-label="Selected robot"
          value={robot ?? ''}
          onChange={(event) => select(event.target.value === '' ? null : Number(event.target.value))}
        >
          <option value="">none</option>
          {all.map((one) => (
            <option key={one.robot} value={one.robot}>
              {one.robot}
            </option>
          ))}
        </select>
      </header>
      {robot === null ? (
        <p className="hint">
          Select a robot on the map or press <kbd>N</kbd> to see its situation, its motor schemas and their
          gains.
        </p>
      ) : seen ? (
        <Details live={live} robot={seen} telemetry={live.telemetry(robot)} operator={operator} />
      ) : (
        <p className="hint">Robot {robot} is not in the world now.</p>
      )}
    </section>
  );
}

function Details(props: { live: LiveRun; robot: ViewedRobot; telemetry: Telemetry | null; operator: boolean }) {
  const { live, robot, telemetry } = props;
  const heading = (Math.atan2(robot.heading_sin, robot.heading_cos) * 180) / Math.PI;
  const speed = Math.hypot(robot.velocity_x_mps, robot.velocity_y_mps);
  const condition = [
    robot.able ? 'able' : '✕ disabled',
    robot.present ? '' : '◌ absent',
    robot.holding ? 'holds something' : '',
  ].filter(Boolean);
  const facts: [string, string][] = [
    ['Role', telemetry?.role || 'none'],
    ['Strategy', telemetry?.learner || '–'],
    ['State', telemetry?.state || 'none'],
    ['Situation', telemetry?.situation || 'none'],
    ['Condition', condition.join(', ')],
    ['Place', `${robot.x_m.toFixed(1)}, ${with_unit(robot.y_m, 'm')}`],
    ['Heading', `${heading.toFixed(0)}°`],
    ['Speed', with_unit(speed, 'm/s', 2)],
  ];
  return (
    <>
      <dl className="details">
        {facts.map(([name, value]) => (
          <div key={name} className={name === 'Situation' || name === 'State' ? 'whole' : undefined}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      {telemetry ? (
        <>
          <Shares shares={telemetry.shares} />
          <p className="hint">On the map: gain × push of each, and their sum as a thick arrow.</p>
          <GainsChart live={live} robot={robot.robot} />
          <p className="hint">Telemetry of {clock(Number(telemetry.tick) * live.tick_s)}.</p>
        </>
      ) : (
        <p className="hint">No telemetry from this robot yet.</p>
      )}
      {props.operator && <Operator live={live} robot={robot.robot} />}
    </>
  );
}

function Shares({ shares }: { shares: SchemaShare[] }) {
  if (shares.length === 0) return <p className="hint">No motor schema is active.</p>;
  const most = Math.max(...shares.map((share) => Math.abs(share.gain)), 1e-9);
  return (
    <table className="shares">
      <caption>Motor schemas</caption>
      <thead>
        <tr>
          <th scope="col">Schema</th>
          <th scope="col">Gain</th>
          <th scope="col">|Push|</th>
        </tr>
      </thead>
      <tbody>
        {shares.map((share, i) => (
          <tr key={share.name}>
            <th scope="row">
              <span className="swatch" style={{ background: series_colour(i) }} aria-hidden="true" />
              {share.name}
            </th>
            <td>
              <span className="bar" aria-hidden="true">
                <span style={{ width: `${(100 * Math.abs(share.gain)) / most}%`, background: series_colour(i) }} />
              </span>
              {share.gain.toFixed(2)}
            </td>
            <td>{Math.hypot(share.push_x, share.push_y).toFixed(2)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

const kSteers: [string, string, number, number][] = [
  ['↑', 'north', 0, 1],
  ['↓', 'south', 0, -1],
  ['←', 'west', -1, 0],
  ['→', 'east', 1, 0],
];

/** The operator's word to one robot. It stands in the event log and the run no longer repeats. */
function Operator({ live, robot }: { live: LiveRun; robot: number }) {
  const [said, set_said] = useState('');
  const call = async (service: string, request: object, done: string) => {
    try {
      await live.call(service, { robot, ...request });
      set_said(done);
    } catch (thrown) {
      set_said(`Not done: ${words_of(thrown)}`);
    }
  };
  return (
    <details className="operator">
      <summary>Operator</summary>
      <p className="hint">A run that was told something cannot be repeated from its seed alone.</p>
      <div className="row">
        <button type="button" onClick={() => call('proceed', {}, '"Proceed" was said.')}>
          Proceed
        </button>
        <button type="button" onClick={() => call('skip_goal', {}, 'It leaves out a goal.')}>
          Skip goal
        </button>
      </div>
      <div className="row" role="group" aria-label="Joystick">
        {kSteers.map(([arrow, name, x, y]) => (
          <button
            key={name}
            type="button"
            aria-label={`Steer ${name}`}
            onClick={() => call('steer', { x, y }, `Steered ${name}.`)}
          >
            {arrow}
          </button>
        ))}
        <button type="button" onClick={() => call('let_go', {}, 'Let go.')}>
          Let go
        </button>
      </div>
      <p role="status" className="hint">
        {said}
      </p>
    </details>
  );
}
