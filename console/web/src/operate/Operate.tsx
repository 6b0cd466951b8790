import { useState } from 'react';

import { api } from '@/api/client';
import type { Run } from '@/api/types';
import { useAsked } from '@/api/use';
import { Loading, Nothing, RunState, Trouble } from '@/app/parts';
import { when } from '@/app/numbers';
import { address_of, go } from '@/app/route';
import { LiveView } from '@/operate/LiveView';
import { StartRun } from '@/operate/StartRun';

const kRunsEvery_ms = 3000;
const kMostShown = 40;

/** The runs there are, and the one that is looked at. */
export function Operate({ run }: { run: string }) {
  const runs = useAsked(api.runs, 'runs', kRunsEvery_ms);
  const [starting, set_starting] = useState(false);
  const shown = run || runs.value?.find((one) => one.state === 'live')?.id || '';
  return (
    <div className="operate">
      <aside className="panel runs" aria-label="Runs">
        <header className="panel-head">
          <h2>Runs</h2>
          <button type="button" onClick={() => set_starting(true)}>
            Start a run
          </button>
        </header>
        <RunList runs={runs.value} error={runs.error} again={runs.again} shown={shown} />
      </aside>
      <section className="stage" aria-label="Live run">
        <Stage run={shown} known={runs.value} error={runs.error} start={() => set_starting(true)} />
      </section>
      <StartRun
        open={starting}
        close={() => set_starting(false)}
        started={(id) => {
          set_starting(false);
          runs.again();
          go('operate', id);
        }}
      />
    </div>
  );
}

function RunList(props: { runs: Run[] | null; error: string; again: () => void; shown: string }) {
  if (props.error && !props.runs) return <Trouble text={props.error} again={props.again} />;
  if (!props.runs) return <Loading what="runs" />;
  if (props.runs.length === 0) return <p className="hint">No run yet.</p>;
  return (
    <>
      <ul className="run-list">
        {props.runs.slice(0, kMostShown).map((run) => (
          <li key={run.id}>
            <a
              href={address_of('operate', run.id)}
              aria-current={run.id === props.shown ? 'true' : undefined}
            >
              <span className="run-name">{run.name || run.id}</span>
              <RunState state={run.state} />
              <span className="run-facts">
                {run.robots} robots · seed {run.seed} · {when(run.started)}
              </span>
            </a>
          </li>
        ))}
      </ul>
      {props.runs.length > kMostShown && <a href={address_of('results')}>All {props.runs.length} runs</a>}
    </>
  );
}

function Stage(props: { run: string; known: Run[] | null; error: string; start: () => void }) {
  const run = props.known?.find((one) => one.id === props.run);
  if (!props.known) return props.error ? <Trouble text={props.error} /> : <Loading what="the run" />;
  if (!props.run) return <NoRun start={props.start} any={props.known.length > 0} />;
  if (!run) return <Trouble text={`There is no run "${props.run}".`} />;
  if (run.state !== 'live') return <OverRun run={run} />;
  return <LiveView key={run.id} run={run} />;
}

function NoRun({ start, any }: { start: () => void; any: boolean }) {
  return (
    <Nothing title="No run is live">
      <p>
        Start one here, plan a mission, or start one from a shell:
        <code>tacit run forage --robots 6</code>
      </p>
      <p className="row">
        <button type="button" className="primary" onClick={start}>
          Start a run
        </button>
        <a className="button" href={address_of('plan')}>
          Plan a mission
        </a>
        {any && (
          <a className="button" href={address_of('results')}>
            See results
          </a>
        )}
      </p>
    </Nothing>
  );
}

function OverRun({ run }: { run: Run }) {
  return (
    <Nothing title={`${run.name || run.id} is over`}>
      <p>
        <RunState state={run.state} /> after {run.ticks} ticks
        {run.score ? `, ${run.score.done} of ${run.score.wanted} sub-tasks done` : ''}.
      </p>
      <p className="row">
        <a className="button primary" href={address_of('results', run.id)}>
          Metrics and checklist
        </a>
        {run.recording && (
          <a className="button" href={address_of('replay', run.id)}>
            Replay
          </a>
        )}
      </p>
    </Nothing>
  );
}
