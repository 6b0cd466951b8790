import type { Check } from '@/api/types';

export function Checklist({ checks }: { checks: Check[] }) {
  const done = checks.filter((check) => check.done).length;
  return (
    <section aria-label="Sub-tasks">
      <h2>
        {done} of {checks.length} sub-tasks done
      </h2>
      <ul className="checklist">
        {checks.map((check) => (
          <li key={check.name} className={check.done ? 'is-done' : 'is-open'}>
            <span aria-hidden="true">{check.done ? '✓' : '✕'}</span>
            <div>
              <strong>
                <span className="unseen">{check.done ? 'Done: ' : 'Not done: '}</span>
                {check.name}
              </strong>
              <p className="hint">{check.evidence}</p>
            </div>
          </li>
        ))}
      </ul>
    </section>
  );
}
