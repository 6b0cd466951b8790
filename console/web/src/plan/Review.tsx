import { useCallback, useEffect, useRef, useState } from 'react';

import { api, words_of } from '@/api/client';
import type { OfferedPlan } from '@/api/types';
import { Loading, Nothing, Trouble } from '@/app/parts';
import { request_of } from '@/plan/draft';
import { PlanDetails } from '@/plan/PlanDetails';
import { Previewer } from '@/plan/Previewer';
import { current_draft, is_planned, useDraft, useSession } from '@/plan/store';

/** Step 2: the wizard's plans, ranked, and why each is as it is. */
export function Review() {
  const draft = useDraft();
  const session = useSession();
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState('');
  const asked = useRef(false);
  const current = is_planned(draft, session.planned);

  const ask = useCallback(async () => {
    const wanted = current_draft();
    set_busy(true);
    set_error('');
    try {
      const answer = await api.plan(wanted.map, request_of(wanted));
      useSession.getState().set({ answer, planned: wanted, chosen: 0, preview: null });
    } catch (thrown) {
      set_error(words_of(thrown));
    }
    set_busy(false);
  }, []);
  useEffect(() => {
    if (asked.current || current) return;
    asked.current = true;
    void ask();
  }, [ask, current]);

  if (busy) return <Loading what="plans: the wizard looks through its cases" />;
  if (error) return <Refusal error={error} again={ask} />;
  const { answer } = session;
  if (!answer || !current) {
    return (
      <Nothing title="The description has changed">
        <button type="button" className="primary" onClick={ask}>
          Plan again
        </button>
      </Nothing>
    );
  }
  const plan = answer.plans[session.chosen] ?? answer.plans[0];
  if (!plan) return <Nothing title="The wizard has no plan for this">{answer.notes.join(' ')}</Nothing>;
  return (
    <div className="review">
      <section className="panel offers" aria-label="Plans">
        <h1>Choose a plan</h1>
        {answer.notes.map((note) => (
          <p key={note} className="note">
            {note}
          </p>
        ))}
        <Offers plans={answer.plans} chosen={session.chosen} />
        <Previewer key={session.chosen} plan={plan} map={draft.map} />
        <div className="row end">
          <button type="button" onClick={() => session.set({ step: 'describe' })}>
            <span aria-hidden="true">←</span> Back
          </button>
          <button type="button" className="primary" onClick={() => session.set({ step: 'run', run: '' })}>
            Run this plan <span aria-hidden="true">→</span>
          </button>
        </div>
      </section>
      <PlanDetails plan={plan} tasks={draft.tasks} number={session.chosen + 1} />
    </div>
  );
}

function Refusal({ error, again }: { error: string; again: () => void }) {
  const set = useSession((state) => state.set);
  return (
    <div className="state">
      <Trouble text={`The wizard makes no plan: ${error}`} again={again} />
      <button type="button" className="primary" onClick={() => set({ step: 'describe' })}>
        Change the description
      </button>
    </div>
  );
}

export function Stars({ stars }: { stars: number }) {
  const full = Math.min(Math.max(Math.round(stars), 0), 5);
  return (
    <span className="stars" role="img" aria-label={`${stars.toFixed(1)} of 5 stars`}>
      {'★'.repeat(full)}
      {'☆'.repeat(5 - full)} <span className="stars-number">{stars.toFixed(1)}</span>
    </span>
  );
}

const counted = (count: number, one: string, more: string) => `${count} ${count === 1 ? one : more}`;

export function words_of_changes({ changes }: OfferedPlan): string {
  const adapted = changes.filter((change) => change.step === 'adapt' && change.mended).length;
  const mended = changes.filter((change) => change.step === 'criticize' && change.mended).length;
  const left = changes.filter((change) => !change.mended).length;
  return [
    counted(adapted, 'adaptation', 'adaptations'),
    `${counted(mended, 'weakness', 'weaknesses')} mended`,
    left > 0 ? counted(left, 'warning', 'warnings') : '',
  ].filter(Boolean).join(', ');
}

function Offers({ plans, chosen }: { plans: OfferedPlan[]; chosen: number }) {
  const set = useSession((state) => state.set);
  return (
    <fieldset className="offer-list">
      <legend className="unseen">Plans, best first</legend>
      {plans.map((plan, i) => (
        <label key={`${i} ${plan.arrangement}`} className={i === chosen ? 'offer chosen' : 'offer'}>
          <input type="radio" name="plan" checked={i === chosen} onChange={() => set({ chosen: i, preview: null })} />
          <span>
            <Stars stars={plan.stars} />
            {i === 0 && <span className="best">best match</span>}
            <strong>{plan.arrangement}</strong>
            <span className="hint">{words_of_changes(plan)}</span>
          </span>
        </label>
      ))}
    </fieldset>
  );
}
