import { useState } from 'react';

import { api, words_of } from '@/api/client';
import type { Run, StartRun } from '@/api/types';
import { useAsked } from '@/api/use';
import { Loading, Nothing, Trouble, TwiceButton } from '@/app/parts';
import { LiveView } from '@/operate/LiveView';
import { problems_of } from '@/plan/check';
import { Debrief } from '@/plan/Debrief';
import { usual_extra } from '@/plan/extra';
import { is_planned, useDraft, useSession } from '@/plan/store';

const kAskEvery_ms = 2000;

/** Step 3: checks, the run itself, the debrief. */
export function RunStep() {
  const { run } = useSession();
  return run ? <Flight run={run} /> : <PreFlight />;
}

interface Line {
  text: string;
  good: boolean;
}

function PreFlight() {
  const draft = useDraft();
  const session = useSession();
  const scene = useAsked(() => api.map(draft.map), `map ${draft.map}`);
  const missions = useAsked(api.missions, 'missions');
  const [wish, set_wish] = useState<{ seed: string; speed: string; extra: string | null }>({
    seed: '', speed: '4', extra: null,
  });
  const [sure, set_sure] = useState(false);
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState('');
  const plan = session.answer?.plans[session.chosen];
  if (!plan || !is_planned(draft, session.planned)) return <Nothing title="Choose a plan first" />;
  const lines = lines_of(draft, scene.value, session.preview?.success?.share ?? null, plan.changes.filter((one) => !one.mended).length);
  const extra = wish.extra ?? usual_extra(draft.preferences.enemy, scene.value);
  const doubts = lines.filter((line) => !line.good).length;

  const run = async () => {
    set_busy(true);
    set_error('');
    const wanted: StartRun = { mission: plan.mission, map_name: draft.map, speed: Number(wish.speed) };
    if (draft.preferences.robots !== null) wanted.robots = draft.preferences.robots;
    if (wish.seed !== '') wanted.seed = Number(wish.seed);
    if (extra !== '') wanted.extra = extra;
    try {
      session.set({ run: (await api.start(wanted)).id });
    } catch (thrown) {
      set_error(words_of(thrown));
    }
    set_busy(false);
  };
  return (
    <section className="panel preflight" aria-label="Before the run">
      <h1>Before the run</h1>
      <p>{plan.arrangement}</p>
      <ul className="checks">
        {lines.map((line) => (
          <li key={line.text} className={line.good ? 'good-words' : 'bad-words'}>
            <span aria-hidden="true">{line.good ? '✓' : '⚠'}</span> {line.text}
          </li>
        ))}
      </ul>
      <div className="fields">
        <label>
          Seed
          <input type="number" min="0" step="1" placeholder="its own" value={wish.seed}
            onChange={(event) => set_wish({ ...wish, seed: event.target.value })} />
        </label>
        <label>
          Speed, × real time
          <input type="number" min="0" step="any" value={wish.speed}
            onChange={(event) => set_wish({ ...wish, speed: event.target.value })} />
        </label>
        <label>
          Others about
          <select value={extra} onChange={(event) => set_wish({ ...wish, extra: event.target.value })}>
            <option value="">nobody</option>
            {(missions.value ?? []).map((mission) => (
              <option key={mission.name} value={mission.name}>
                {mission.name}
              </option>
            ))}
          </select>
        </label>
      </div>
      {doubts > 0 && (
        <label className="check">
          <input type="checkbox" checked={sure} onChange={() => set_sure(!sure)} />
          Run it all the same
        </label>
      )}
      {error && <Trouble text={error} />}
      <div className="row end">
        <button type="button" onClick={() => session.set({ step: 'review' })}>
          <span aria-hidden="true">←</span> Back
        </button>
        <button type="button" className="primary go" disabled={busy || (doubts > 0 && !sure)} onClick={run}>
          {busy ? 'Starting …' : 'Run'}
        </button>
      </div>
    </section>
  );
}

function lines_of(
  draft: Parameters<typeof problems_of>[0], scene: Parameters<typeof problems_of>[1],
  success: number | null, warnings: number,
): Line[] {
  const problems = problems_of(draft, scene);
  const many = draft.tasks.length === 1 ? '1 task' : `${draft.tasks.length} tasks`;
  return [
    { good: scene !== null, text: `${many} on the map "${draft.map}"` },
    problems.length === 0
      ? { good: true, text: 'Nothing is wrong with the description' }
      : { good: false, text: `The description has ${problems.length} problems left` },
    warnings === 0
      ? { good: true, text: 'The wizard has no warning about the plan' }
      : { good: false, text: `Warnings of the wizard that are not mended: ${warnings}` },
    success === null
      ? { good: false, text: 'The plan was not previewed' }
      : { good: success >= 0.5, text: `${Math.round(100 * success)} % of the previewed flights succeeded` },
  ];
}

function Flight({ run }: { run: string }) {
  const session = useSession();
  const runs = useAsked(api.runs, `plan ${run}`, kAskEvery_ms);
  const [error, set_error] = useState('');
  const known = runs.value?.find((one) => one.id === run);
  const abort = async () => {
    try {
      await api.stop(run);
      runs.again();
    } catch (thrown) {
      set_error(words_of(thrown));
    }
  };
  if (!runs.value) return runs.error ? <Trouble text={runs.error} again={runs.again} /> : <Loading what="the run" />;
  if (!known) {
    return (
      <Nothing title="The run is gone">
        <button type="button" onClick={() => session.set({ run: '' })}>
          Back to the checks
        </button>
      </Nothing>
    );
  }
  return (
    <div className="flight">
      {known.state === 'live' ? <LiveBar run={known} abort={abort} error={error} /> : <Debrief run={known} />}
      {known.state === 'live' && <LiveView run={known} />}
    </div>
  );
}

function LiveBar({ run, abort, error }: { run: Run; abort: () => void; error: string }) {
  return (
    <div className="abort-bar">
      <strong>The plan is being run as {run.name || run.id}.</strong>
      {error && <span className="bad-words">{error}</span>}
      <span className="spacer" />
      <TwiceButton className="danger big" label="Abort the mission" sure="Press again to abort" act={abort} />
    </div>
  );
}
