import { useEffect } from 'react';

import { Describe } from '@/plan/Describe';
import { problems_of } from '@/plan/check';
import { Review } from '@/plan/Review';
import { RunStep } from '@/plan/RunStep';
import { is_planned, useDraft, useHistory, useSession, type Step } from '@/plan/store';
import '@/plan/plan.css';

const kSteps: [Step, string, string][] = [
  ['describe', 'Describe', 'What is wanted, and where'],
  ['review', 'Review', 'What the wizard offers'],
  ['run', 'Run', 'Fly it and look back'],
];

export default function Plan() {
  const session = useSession();
  const draft = useDraft();
  useUndoKeys(session.step === 'describe');
  const errors = problems_of(draft, null).filter((problem) => problem.level === 'error').length;
  const open: Record<Step, boolean> = {
    describe: true,
    review: errors === 0,
    run: session.answer !== null && is_planned(draft, session.planned),
  };
  const step = open[session.step] || session.run ? session.step : 'describe';
  return (
    <div className="plan">
      <div className="steps-bar">
      <ol className="steps" aria-label="Steps of a plan">
        {kSteps.map(([key, name, help], i) => (
          <li key={key}>
            <button
              type="button"
              aria-current={key === step ? 'step' : undefined}
              disabled={!open[key] && key !== step}
              onClick={() => session.set({ step: key })}
            >
              <span className="step-number" aria-hidden="true">
                {i + 1}
              </span>
              <span>
                <strong>{name}</strong>
                <small>{help}</small>
              </span>
            </button>
          </li>
        ))}
      </ol>
      <p className="saved" role="status">
        {session.unsaved ? '● saving' : '✓ saved in this browser'}
      </p>
      </div>
      {step === 'describe' && <Describe />}
      {step === 'review' && <Review />}
      {step === 'run' && <RunStep />}
    </div>
  );
}

function useUndoKeys(on: boolean): void {
  const { undo, redo } = useHistory();
  useEffect(() => {
    if (!on) return;
    const pressed = (event: KeyboardEvent) => {
      if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 'z') return;
      if (event.target instanceof HTMLInputElement && event.target.type === 'text') return;
      event.preventDefault();
      if (event.shiftKey) redo();
      else undo();
    };
    window.addEventListener('keydown', pressed);
    return () => window.removeEventListener('keydown', pressed);
  }, [on, undo, redo]);
}
