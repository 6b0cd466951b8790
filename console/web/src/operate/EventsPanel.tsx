import { useEffect, useMemo, useRef, useState } from 'react';

import { Announcer } from '@/app/parts';
import { clock } from '@/app/numbers';
import type { LiveRun, LoggedEvent } from '@/live/live_run';
import { useNews } from '@/operate/use_live';
import { group_of, is_grave, kGroups, words_of_event, type Group } from '@/operate/words_of_event';

const kRow_px = 28;
const kMoreRows = 6;

export function matches(logged: LoggedEvent, groups: readonly Group[], robot: number | null, words: string): boolean {
  const { event } = logged;
  if (!groups.includes(group_of(event))) return false;
  if (robot !== null && event.robot !== robot && event.other_robot !== robot) return false;
  return words === '' || words_of_event(event).toLowerCase().includes(words.toLowerCase());
}

/** The newest stay in sight until somebody scrolls up. */
export function EventsPanel({ live, select }: { live: LiveRun; select: (robot: number) => void }) {
  const news = useNews(live);
  const [groups, set_groups] = useState<Group[]>(kGroups);
  const [words, set_words] = useState('');
  const shown = useMemo(
    () => live.events.filter((logged) => matches(logged, groups, null, words)),
    // The log grows in place; `news` says that it may have.
    // eslint-disable-next-line react-hooks/exhaustive-deps
    [live, news, groups, words],
  );
  const newest = live.events[live.events.length - 1];
  const toggle = (group: Group) =>
    set_groups(groups.includes(group) ? groups.filter((one) => one !== group) : [...groups, group]);
  return (
    <section className="panel events" aria-label="Events">
      <header className="panel-head">
        <h2>Events</h2>
        <div className="row" role="group" aria-label="Which events">
          {kGroups.map((group) => (
            <button key={group} type="button" aria-pressed={groups.includes(group)} onClick={() => toggle(group)}>
              {group}
            </button>
          ))}
        </div>
        <input
          type="search" placeholder="Filter, such as robot 3" aria-label="Filter events" value={words}
          onChange={(event) => set_words(event.target.value)}
        />
        <span className="hint">
          {shown.length} of {live.events.length}
          {live.missed_events > 0 ? `, ${live.missed_events} were missed` : ''}
        </span>
      </header>
      <Rows events={shown} tick_s={live.tick_s} select={select} />
      <Announcer text={newest ? `Event ${newest.index + 1}: ${words_of_event(newest.event)}` : ''} />
    </section>
  );
}

function Rows(props: { events: LoggedEvent[]; tick_s: number; select: (robot: number) => void }) {
  const { events } = props;
  const box = useRef<HTMLDivElement>(null);
  const [top, set_top] = useState(0);
  const [height, set_height] = useState(160);
  const at_end = useRef(true);
  useEffect(() => {
    const watch = new ResizeObserver(() => set_height(box.current?.clientHeight ?? 160));
    watch.observe(box.current!);
    return () => watch.disconnect();
  }, []);
  useEffect(() => {
    if (at_end.current && box.current) box.current.scrollTop = box.current.scrollHeight;
  }, [events.length]);
  const scrolled = () => {
    const { scrollTop, clientHeight, scrollHeight } = box.current!;
    at_end.current = scrollTop + clientHeight >= scrollHeight - kRow_px;
    set_top(scrollTop);
  };
  const first = Math.max(0, Math.floor(top / kRow_px) - kMoreRows);
  const last = Math.min(events.length, Math.ceil((top + height) / kRow_px) + kMoreRows);
  return (
    <div
      ref={box} className="rows" role="log" aria-live="off" aria-label="Event log" tabIndex={0}
      onScroll={scrolled}
    >
      {events.length === 0 && <p className="hint">No event yet that fits.</p>}
      <div style={{ height: `${events.length * kRow_px}px` }} className="rows-all">
        {events.slice(first, last).map((logged, i) => (
          <Row key={logged.index} logged={logged} top_px={(first + i) * kRow_px} {...props} />
        ))}
      </div>
    </div>
  );
}

function Row(props: { logged: LoggedEvent; top_px: number; tick_s: number; select: (robot: number) => void }) {
  const { event } = props.logged;
  const group = group_of(event);
  return (
    <div className={`event ${group} ${is_grave(event) ? 'grave' : ''}`} style={{ top: `${props.top_px}px` }}>
      <time>{clock(Number(event.tick) * props.tick_s)}</time>
      <span className="event-group">{group}</span>
      <span className="event-words">
        {is_grave(event) && <span aria-label="Look at this: ">⚠ </span>}
        {words_of_event(event)}
      </span>
      {event.robot > 0 && (
        <button type="button" className="quiet" onClick={() => props.select(event.robot)}>
          Robot {event.robot}
        </button>
      )}
    </div>
  );
}
