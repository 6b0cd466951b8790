import { useMemo, useState } from 'react';

import { api } from '@/api/client';
import type { Run } from '@/api/types';
import { useAsked } from '@/api/use';
import { when } from '@/app/numbers';
import { Loading, Nothing, RunState, Trouble } from '@/app/parts';
import { address_of } from '@/app/route';
import { save_csv } from '@/results/csv';
import { RunPage } from '@/results/RunPage';
import { filtered, sorted, type Column, type Filter, type Sorting } from '@/results/table';
import '@/results/results.css';

const kRunsEvery_ms = 5000;
const kPage = 200;
const kColumns: [Column, string, boolean][] = [
  ['name', 'Name', false],
  ['scenario', 'Scenario', false],
  ['state', 'State', false],
  ['started', 'Started', false],
  ['robots', 'Robots', true],
  ['seed', 'Seed', true],
  ['ticks', 'Ticks', true],
  ['score', 'Sub-tasks', true],
];

export default function Results({ run }: { run: string }) {
  return run ? <RunPage key={run} id={run} /> : <RunTable />;
}

function RunTable() {
  const runs = useAsked(api.runs, 'results', kRunsEvery_ms);
  const [sorting, set_sorting] = useState<Sorting>({ by: 'started', down: true });
  const [filter, set_filter] = useState<Filter>({ words: '', state: '' });
  const [most, set_most] = useState(kPage);
  const shown = useMemo(
    () => sorted(filtered(runs.value ?? [], filter), sorting),
    [runs.value, filter, sorting],
  );
  if (runs.error && !runs.value) return <Trouble text={runs.error} again={runs.again} />;
  if (!runs.value) return <Loading what="runs" />;
  if (runs.value.length === 0) {
    return (
      <Nothing title="There are no results yet">
        <p>A run that has ended stands here with its metrics.</p>
        <a className="button primary" href={address_of('operate')}>
          Start a run
        </a>
      </Nothing>
    );
  }
  return (
    <div className="results">
      <header className="panel results-head">
        <h1>Results</h1>
        <input
          type="search" aria-label="Filter runs" placeholder="Filter, such as guard seed 7" value={filter.words}
          onChange={(event) => set_filter({ ...filter, words: event.target.value })}
        />
        <label className="row">
          State
          <select
            value={filter.state}
            onChange={(event) => set_filter({ ...filter, state: event.target.value as Filter['state'] })}
          >
            <option value="">all</option>
            {['live', 'done', 'stopped', 'failed'].map((state) => (
              <option key={state}>{state}</option>
            ))}
          </select>
        </label>
        <span className="hint" role="status">
          {shown.length} of {runs.value.length} runs
        </span>
        <span className="spacer" />
        <button type="button" disabled={shown.length === 0} onClick={() => save_csv('runs.csv', rows_of(shown))}>
          Export CSV
        </button>
      </header>
      <div className="panel results-table" tabIndex={0} role="group" aria-label="Table of runs">
        <table>
          <thead>
            <tr>
              {kColumns.map(([column, name, is_number]) => (
                <Head key={column} {...{ column, name, is_number, sorting }} sort={set_sorting} />
              ))}
              <th scope="col">Recording</th>
            </tr>
          </thead>
          <tbody>
            {shown.slice(0, most).map((run) => (
              <Row key={run.id} run={run} />
            ))}
          </tbody>
        </table>
        {shown.length === 0 && (
          <Nothing title="No run fits the filter">
            <button type="button" onClick={() => set_filter({ words: '', state: '' })}>
              Show all
            </button>
          </Nothing>
        )}
        {shown.length > most && (
          <button type="button" onClick={() => set_most(most + kPage)}>
            Show more ({shown.length - most} left)
          </button>
        )}
      </div>
    </div>
  );
}

function Head(props: {
  column: Column; name: string; is_number: boolean; sorting: Sorting; sort: (sorting: Sorting) => void;
}) {
  const { column, sorting } = props;
  const here = sorting.by === column;
  return (
    <th
      scope="col" className={props.is_number ? 'number' : ''}
      aria-sort={here ? (sorting.down ? 'descending' : 'ascending') : undefined}
    >
      <button
        type="button" className="quiet"
        onClick={() => props.sort({ by: column, down: here ? !sorting.down : props.is_number })}
      >
        {props.name} <span aria-hidden="true">{here ? (sorting.down ? '▼' : '▲') : '↕'}</span>
      </button>
    </th>
  );
}

function Row({ run }: { run: Run }) {
  return (
    <tr>
      <th scope="row">
        <a href={address_of(run.state === 'live' ? 'operate' : 'results', run.id)}>{run.name || run.id}</a>
      </th>
      <td>{run.scenario}</td>
      <td>
        <RunState state={run.state} />
      </td>
      <td>{when(run.started)}</td>
      <td className="number">{run.robots}</td>
      <td className="number">{run.seed}</td>
      <td className="number">{run.ticks}</td>
      <td className="number">{run.score ? `${run.score.done} of ${run.score.wanted}` : '–'}</td>
      <td>
        {run.recording && run.state !== 'live' ? (
          <a href={address_of('replay', run.id)} aria-label={`Replay ${run.name || run.id}`}>
            <span aria-hidden="true">▶</span> Replay
          </a>
        ) : (
          <span title={run.recording ? 'When the run is over' : 'Made by tacit run --record'}>
            {run.recording ? 'going on' : 'none'}
          </span>
        )}
      </td>
    </tr>
  );
}

function rows_of(runs: Run[]) {
  return [
    ['id', 'name', 'scenario', 'state', 'started', 'robots', 'seed', 'ticks', 'done', 'wanted'],
    ...runs.map((run) => [
      run.id, run.name, run.scenario, run.state, run.started, run.robots, run.seed, run.ticks,
      run.score?.done, run.score?.wanted,
    ]),
  ];
}
