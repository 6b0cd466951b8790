import { useSettings } from '@/app/settings';
import type { LiveRun } from '@/live/live_run';

interface Props {
  live: LiveRun;
  follow: boolean;
  toggle_follow: () => void;
  can_follow: boolean;
}

/** What the map shows beside the world. */
export function Layers({ live, follow, toggle_follow, can_follow }: Props) {
  const settings = useSettings();
  const switches = [
    ['trails', 'Trails', 'T'],
    ['vectors', 'Pushes', 'V'],
    ['sensors', 'Sensor range', 'S'],
    ['labels', 'Numbers', ''],
  ] as const;
  return (
    <div className="layers" role="group" aria-label="Layers of the map">
      {switches.map(([key, name, letter]) => (
        <button
          key={key}
          type="button"
          aria-pressed={settings[key]}
          aria-keyshortcuts={letter || undefined}
          onClick={() => settings.set({ [key]: !settings[key] })}
        >
          {name} {letter && <kbd aria-hidden="true">{letter}</kbd>}
        </button>
      ))}
      <button type="button" aria-pressed={follow} disabled={!can_follow} onClick={toggle_follow}>
        Follow <kbd aria-hidden="true">L</kbd>
      </button>
      <details className="more">
        <summary>More</summary>
        <div className="more-box">
          <label>
            Trail length, s
            <input
              type="number" min="1" max="3600" value={settings.trail_s}
              onChange={(event) => settings.set({ trail_s: Math.max(1, Number(event.target.value)) })}
            />
          </label>
          <label>
            Radius of the sensor ring, m
            <input
              type="number" min="0.5" max="1000" step="0.5" value={settings.sensor_m}
              onChange={(event) => settings.set({ sensor_m: Math.max(0.5, Number(event.target.value)) })}
            />
          </label>
          <button type="button" onClick={() => live.clear_trails()}>
            Clear trails
          </button>
        </div>
      </details>
    </div>
  );
}
