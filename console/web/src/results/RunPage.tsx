import { useState } from 'react';

import { api, words_of } from '@/api/client';
import type { RunDetail } from '@/api/types';
import { useAsked } from '@/api/use';
import { when } from '@/app/numbers';
import { Loading, RunState, Trouble } from '@/app/parts';
import { address_of, go } from '@/app/route';
import { Checklist } from '@/results/Checklist';
import { save_csv } from '@/results/csv';
import { Metrics } from '@/results/Metrics';

export function RunPage({ id }: { id: string }) {
  const asked = useAsked(() => api.run(id), `run ${id}`);
  return (
    <div className="run-page">
      <a href={address_of('results')}>
        <span aria-hidden="true">←</span> All runs
      </a>
      {asked.error && <Trouble text={asked.error} again={asked.again} />}
      {!asked.value && !asked.error && <Loading what="the run" />}
      {asked.value && <Detail run={asked.value} />}
    </div>
  );
}

function Detail({ run }: { run: RunDetail }) {
  const [error, set_error] = useState('');
  const facts: [string, string][] = [
    ['Scenario', run.scenario],
    ['Seed', String(run.seed)],
    ['Robots', String(run.robots)],
    ['Ticks', String(run.ticks)],
    ['Started', when(run.started)],
    ['Sub-tasks', run.score ? `${run.score.done} of ${run.score.wanted}` : 'none'],
  ];
  const again = async () => {
    try {
      const { id } = await api.start({ scenario: run.scenario, seed: run.seed, robots: run.robots });
      go('operate', id);
    } catch (thrown) {
      set_error(words_of(thrown));
    }
  };
  return (
    <>
      <header className="panel">
        <div className="panel-head">
          <h1>
            {run.name || run.id} <RunState state={run.state} />
          </h1>
          <div className="row">
            {run.recording && run.state !== 'live' && (
              <a className="button primary" href={address_of('replay', run.id)}>
                <span aria-hidden="true">▶</span> Replay
              </a>
            )}
            {!run.checklist && (
              <button type="button" onClick={again}>
                Same scenario and seed again
              </button>
            )}
            <button type="button" onClick={() => save_csv(`${run.id}.csv`, rows_of(run))}>
              Export CSV
            </button>
          </div>
        </div>
        <dl className="facts run-facts-row">
          {facts.map(([name, value]) => (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{value}</dd>
            </div>
          ))}
        </dl>
        {!run.recording && (
          <p className="hint">
            This run was not recorded and cannot be played. <code>tacit run --record</code> records one.
          </p>
        )}
        {error && <Trouble text={error} />}
      </header>
      <section className="panel" aria-label="Metrics">
        <Metrics metrics={run.metrics} />
      </section>
      {run.checklist && (
        <div className="panel">
          <Checklist checks={run.checklist} />
        </div>
      )}
    </>
  );
}

function rows_of(run: RunDetail) {
  return [
    ['kind', 'name', 'value', 'unit', 'meaning'],
    ...run.metrics.map((metric) => ['metric', metric.name, metric.value, metric.unit, metric.meaning]),
    ...(run.checklist ?? []).map((check) => ['sub-task', check.name, check.done ? 1 : 0, '', check.evidence]),
  ];
}
