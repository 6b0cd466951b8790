import { change, kSafe, type Preferences as Wanted } from '@/plan/draft';
import { useDraft } from '@/plan/store';

/** For the whole mission. The defaults are the safe side of each. */
export function Preferences() {
  const { preferences, change: change_draft } = useDraft();
  const set = (fields: Partial<Wanted>) =>
    change_draft((now) => change.prefer(now, fields), `prefer ${Object.keys(fields).join()}`);
  return (
    <section aria-label="Mission preferences" className="preferences">
      <div className="panel-head">
        <h2>Mission preferences</h2>
        <button type="button" className="quiet" onClick={() => set(kSafe)}>
          Safe defaults
        </button>
      </div>
      <div className="fields">
        <label>
          Robots
          <select
            value={preferences.robots ?? ''}
            onChange={(event) => set({ robots: event.target.value === '' ? null : Number(event.target.value) })}
          >
            <option value="">as the best cases have it</option>
            {Array.from({ length: 10 }, (_, i) => (
              <option key={i} value={i + 1}>
                {i + 1}
              </option>
            ))}
          </select>
        </label>
        <label>
          Plans to compare
          <input
            type="number" min="1" max="20" value={preferences.top}
            onChange={(event) => set({ top: Math.min(Math.max(event.target.valueAsNumber || 1, 1), 20) })}
          />
        </label>
      </div>
      <Slider label="Max velocity" unit=" m/s" value={preferences.max_velocity_mps} step={0.05}
        help="No robot goes faster." set={(max_velocity_mps) => set({ max_velocity_mps })} />
      <Slider label="Aggressiveness" unit="" value={preferences.aggressiveness} step={0.05}
        help="The share of the velocity that a robot goes at: low is careful."
        set={(aggressiveness) => set({ aggressiveness })} />
      <label className="check">
        <input type="checkbox" checked={preferences.enemy} onChange={() => set({ enemy: !preferences.enemy })} />
        An enemy is expected
      </label>
    </section>
  );
}

function Slider(props: {
  label: string; unit: string; value: number; step: number; help: string; set: (value: number) => void;
}) {
  const text = `${props.value.toFixed(2)}${props.unit}`;
  return (
    <label className="slider">
      <span>
        {props.label} <output>{text}</output>
      </span>
      <input
        type="range" min="0.1" max="1" step={props.step} value={props.value} aria-valuetext={text}
        onChange={(event) => props.set(event.target.valueAsNumber)}
      />
      <span className="hint">{props.help}</span>
    </label>
  );
}
