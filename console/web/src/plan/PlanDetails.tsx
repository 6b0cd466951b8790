import type { OfferedPlan, PlanChange, UsedCase } from '@/api/types';
import { name_of, type DraftTask } from '@/plan/draft';

/** Why a plan is as it is: its cases, and each change as a before and an after. */
export function PlanDetails(props: { plan: OfferedPlan; tasks: DraftTask[]; number: number }) {
  const { plan, tasks } = props;
  const adapted = plan.changes.filter((change) => change.step === 'adapt');
  const criticized = plan.changes.filter((change) => change.step === 'criticize');
  return (
    <section className="panel plan-details" aria-label={`Plan ${props.number} explained`}>
      <h2>Matched cases</h2>
      <p className="hint">A case is a mission that was flown before. Each task is planned from the one that fits best.</p>
      {plan.cases.map((used) => (
        <Case key={`${used.task} ${used.id}`} used={used} tasks={tasks} />
      ))}
      <Changes title="Adaptations" none="The cases fit as they are." changes={adapted}
        help="What was changed so that the cases do what is wanted here." />
      <Changes title="Criticism" none="No weakness was found." changes={criticized}
        help="Weaknesses that were found in the plan, and how they were mended." />
      <details className="cdl">
        <summary>The mission in CDL</summary>
        <a
          className="button" download="plan.cdl"
          href={`data:text/plain;charset=utf-8,${encodeURIComponent(plan.mission)}`}
        >
          Save as a file
        </a>
        <pre tabIndex={0}>{plan.mission}</pre>
      </details>
    </section>
  );
}

function Case({ used, tasks }: { used: UsedCase; tasks: DraftTask[] }) {
  const task = tasks[used.task];
  const fits = used.features.filter((feature) => feature.matches).length;
  return (
    <details className="case" open={fits < used.features.length}>
      <summary>
        <span>
          Task {used.task + 1}
          {task ? `, ${name_of(task.task)}` : ''}: <strong>case {used.id}</strong>, {used.title}{' '}
          <span className="hint">
            {fits} of {used.features.length} features fit
          </span>
        </span>
      </summary>
      {used.record && <p className="hint">Record: {used.record}</p>}
      <table>
        <thead>
          <tr>
            <th scope="col">Feature</th>
            <th scope="col">Wanted</th>
            <th scope="col">In the case</th>
            <th scope="col">Fits</th>
          </tr>
        </thead>
        <tbody>
          {used.features.map((feature) => (
            <tr key={feature.feature} className={feature.matches ? '' : 'misfit'}>
              <th scope="row">{feature.feature}</th>
              <td>{feature.wanted || <span className="hint">left open</span>}</td>
              <td>{feature.found}</td>
              <td>{feature.matches ? '✓ yes' : '✕ no'}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </details>
  );
}

function Changes(props: { title: string; help: string; none: string; changes: PlanChange[] }) {
  return (
    <section className="changes" aria-label={props.title}>
      <h2>{props.title}</h2>
      <p className="hint">{props.changes.length > 0 ? props.help : props.none}</p>
      <ul>
        {props.changes.map((change, i) => (
          <li key={`${i} ${change.rule}`} className={change.mended ? '' : 'left'}>
            <p>
              <span aria-hidden="true">{change.mended ? (change.step === 'adapt' ? '→ ' : '! ') : '⚠ '}</span>
              <code>{change.rule}</code> {change.why}
              {!change.mended && <strong> Not mended: it is likely to go wrong.</strong>}
            </p>
            {change.before && (
              <pre className="before">
                <span className="unseen">Before: </span>− {change.before}
              </pre>
            )}
            {change.after && (
              <pre className="after">
                <span className="unseen">After: </span>+ {change.after}
              </pre>
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}
