import { useMemo } from 'react';

import { clock } from '@/app/numbers';
import type { LiveRun } from '@/live/live_run';
import { listed, type EventFilter } from '@/operate/event_filter';
import { useNews } from '@/operate/use_live';
import { bookmarks_of, type Bookmark } from '@/replay/bookmarks';
import type { Player } from '@/replay/use_player';

const kWide = 1000;

/** Seconds that a key moves by. */
const kKeys: Record<string, number> = {
  ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10,
  Home: -Infinity, End: Infinity,
};

/** The time of a recording as a slider, with marks where something happened. */
export function Scrubber({ live, player, filter }: { live: LiveRun; player: Player; filter: EventFilter }) {
  const news = useNews(live);
  const { groups, words, checkpoints } = filter;
  const marks = useMemo(
    () => bookmarks_of(listed(live.log, filter), live.tick_s),
    // The log grows in place; `news` says that it may have.
    // eslint-disable-next-line react-hooks/exhaustive-deps
    [live, news, groups, words, checkpoints],
  );
  const { start_s = 0, end_s = 1 } = live.playing ?? {};
  const time_s = player.time_s();
  const pressed = (event: React.KeyboardEvent) => {
    const by = kKeys[event.key];
    if (by === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    player.go_by(by);
  };
  const place = (mark: Bookmark) => (kWide * (mark.time_s - start_s)) / Math.max(end_s - start_s, 1e-9);
  const path = (grave: boolean) =>
    marks.filter((mark) => mark.grave === grave).map((mark) => `M${place(mark).toFixed(1)} 0V8`).join('');
  return (
    <div className="scrubber">
      <span className="scrub-time" aria-hidden="true">{clock(time_s)}</span>
      <div className="scrub-bar">
        <input
          type="range" aria-label="Time" min={start_s} max={end_s} step="any" value={time_s}
          aria-valuetext={`${clock(time_s)} of ${clock(end_s)}`} disabled={!live.playing}
          onChange={(event) => player.go(Number(event.target.value))} onKeyDown={pressed}
        />
        <svg viewBox={`0 0 ${kWide} 8`} preserveAspectRatio="none" role="img" aria-label={`${marks.length} marks of events`}>
          <path className="mark-event" d={path(false)} />
          <path className="mark-event grave" d={path(true)} />
        </svg>
      </div>
      <span className="scrub-time" aria-hidden="true">{clock(end_s)}</span>
    </div>
  );
}
