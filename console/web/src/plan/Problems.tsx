import type { Problem } from '@/plan/check';
import { useDraft } from '@/plan/store';

/** What is wrong, why, and a button that mends it. */
export function Problems({ problems, select }: { problems: Problem[]; select: (task: number) => void }) {
  const change = useDraft((state) => state.change);
  const errors = problems.filter((problem) => problem.level === 'error').length;
  return (
    <section className="problems" aria-label="Problems">
      <p role="status" className={errors > 0 ? 'bad-words' : 'good-words'}>
        {problems.length === 0
          ? '✓ Nothing is wrong with the description.'
          : `${errors} ${errors === 1 ? 'error' : 'errors'}, ${problems.length - errors} ${
              problems.length - errors === 1 ? 'warning' : 'warnings'
            }`}
      </p>
      <ul>
        {problems.map((problem) => (
          <li key={problem.what} className={problem.level}>
            <span aria-hidden="true">{problem.level === 'error' ? '✕' : '⚠'}</span>
            <div>
              <strong>
                <span className="unseen">{problem.level}: </span>
                {problem.what}.
              </strong>{' '}
              <span>{problem.why}</span>
            </div>
            {problem.fix && (
              <button
                type="button"
                onClick={() => {
                  change(problem.fix!.apply);
                  if (problem.task !== undefined) select(problem.task);
                }}
              >
                {problem.fix.label}
              </button>
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}
