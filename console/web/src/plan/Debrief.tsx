import { useState } from 'react';

import { api, words_of } from '@/api/client';
import type { Run, RunDetail } from '@/api/types';
import { useAsked } from '@/api/use';
import { Loading, RunState, Trouble } from '@/app/parts';
import { address_of } from '@/app/route';
import { features_of } from '@/plan/features';
import { useSession } from '@/plan/store';
import { Checklist } from '@/results/Checklist';
import { Metrics } from '@/results/Metrics';

/** What a mission got done, and what the wizard should learn of it. */
export function Debrief({ run }: { run: Run }) {
  const asked = useAsked(() => api.run(run.id), `debrief ${run.id} ${run.state}`);
  const session = useSession();
  if (asked.error) return <Trouble text={asked.error} again={asked.again} />;
  if (!asked.value) return <Loading what="the debrief" />;
  const detail = asked.value;
  return (
    <div className="debrief">
      <section className="panel" aria-label="Debrief">
        <div className="panel-head">
          <h1>
            Debrief <RunState state={detail.state} />
          </h1>
          <div className="row">
            <a className="button" href={address_of('results', run.id)}>
              In the results
            </a>
            <button type="button" onClick={() => session.set({ run: '' })}>
              Run again
            </button>
            <button
              type="button" className="primary"
              onClick={() => session.set({ run: '', step: 'describe' })}
            >
              New plan
            </button>
          </div>
        </div>
        {detail.checklist && <Checklist checks={detail.checklist} />}
        <Metrics metrics={detail.metrics} />
      </section>
      <aside className="panel teach" aria-label="Teach the wizard">
        <Rate detail={detail} />
        <Store />
      </aside>
    </div>
  );
}

function measured(detail: RunDetail): number {
  const { checklist, score } = detail;
  if (score && score.wanted > 0) return score.done / score.wanted;
  if (checklist && checklist.length > 0) return checklist.filter((one) => one.done).length / checklist.length;
  return detail.state === 'done' ? 1 : 0;
}

function Rate({ detail }: { detail: RunDetail }) {
  const { answer, chosen, planned } = useSession();
  const [score, set_score] = useState(() => Math.round(100 * measured(detail)));
  const [said, set_said] = useState('');
  const plan = answer?.plans[chosen];
  if (!plan || plan.cases.length === 0) return null;
  const failures = (detail.checklist ?? []).filter((one) => !one.done).map((one) => `${one.name}: ${one.evidence}`);
  const send = async () => {
    try {
      await api.rate([...new Set(plan.cases.map((used) => used.id))], score / 100, failures, planned?.map ?? '');
      set_said('✓ The wizard has noted it for the cases of this plan.');
    } catch (thrown) {
      set_said(`⚠ Not noted: ${words_of(thrown)}`);
    }
  };
  return (
    <section aria-label="Rate the plan">
      <h2>How did the plan do?</h2>
      <label className="slider">
        <span>
          Score <output>{score} %</output>
        </span>
        <input
          type="range" min="0" max="100" step="5" value={score} aria-valuetext={`${score} %`}
          onChange={(event) => set_score(event.target.valueAsNumber)}
        />
        <span className="hint">
          It stands at what the debrief says. {failures.length === 1 ? '1 failure goes' : `${failures.length} failures go`} with it.
        </span>
      </label>
      <button type="button" onClick={send}>
        Tell the wizard
      </button>
      <p role="status" className="hint">
        {said}
      </p>
    </section>
  );
}

function Store() {
  const { answer, chosen, planned } = useSession();
  const [title, set_title] = useState('');
  const [said, set_said] = useState('');
  const plan = answer?.plans[chosen];
  if (!plan || !planned) return null;
  const store = async (event: React.FormEvent) => {
    event.preventDefault();
    try {
      const features = features_of(planned.tasks, plan, planned.preferences.robots);
      set_said(`✓ ${(await api.store(plan.mission, title, features)).text}`);
    } catch (thrown) {
      set_said(`⚠ Not stored: ${words_of(thrown)}`);
    }
  };
  return (
    <form className="form" onSubmit={store} aria-label="Store as a case">
      <h2>Keep it as a case</h2>
      <p className="hint">The wizard will then find this plan for missions like this one.</p>
      <label>
        Title
        <input
          type="text" required maxLength={200} value={title} placeholder="Office, two robots, seen through"
          onChange={(event) => set_title(event.target.value)}
        />
      </label>
      <div className="row">
        <button type="submit">Store the case</button>
      </div>
      <p role="status" className="hint">
        {said}
      </p>
    </form>
  );
}
