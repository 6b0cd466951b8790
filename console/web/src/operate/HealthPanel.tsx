import { kStaleAfter_ms, type Health, type LiveRun } from '@/live/live_run';
import { useNews } from '@/operate/use_live';

function word_of(health: Health, run: LiveRun): string {
  if (run.stale) return '◌ old';
  if (!run.robots.get(health.robot)?.present) return '◌ absent';
  if (!run.paused && health.heard_ms > 2 * kStaleAfter_ms) return '⚠ silent';
  if (health.rejected > 0 || health.late > 0) return '! look';
  return '✓ well';
}

/** How each robot's process answers. */
export function HealthPanel({ live, select }: { live: LiveRun; select: (robot: number) => void }) {
  useNews(live);
  const all = live.health();
  const { status } = live;
  return (
    <section className="health" aria-label="Agents">
      <h2>Agents</h2>
      {all.length === 0 ? (
        <p className="hint">No telemetry yet.</p>
      ) : (
        <div className="scroll" tabIndex={0} role="group" aria-label="Table of agents">
          <table>
            <thead>
              <tr>
                <th scope="col">Robot</th>
                <th scope="col">Is</th>
                <th scope="col">Hz</th>
                <th scope="col">Decisions</th>
                <th scope="col">Late</th>
                <th scope="col">Refused</th>
              </tr>
            </thead>
            <tbody>
              {all.map((health) => (
                <tr key={health.robot}>
                  <th scope="row">
                    <button type="button" className="quiet" onClick={() => select(health.robot)}>
                      {health.robot}
                    </button>
                  </th>
                  <td>{word_of(health, live)}</td>
                  <td>{health.rate_hz.toFixed(1)}</td>
                  <td>{health.decisions}</td>
                  <td>{health.late}</td>
                  <td>{health.rejected}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
      {status && (
        <p className="hint">
          {status.resent} percepts sent again, {status.rejected} samples refused,{' '}
          {status.repeatable ? 'repeatable from its seed' : 'not repeatable from its seed alone'}.
        </p>
      )}
    </section>
  );
}
