import { useEffect, useMemo, useRef, useState } from 'react';

import { Announcer } from '@/app/parts';
import { clock } from '@/app/numbers';
import type { LiveRun, LoggedEvent } from '@/live/live_run';
import { listed, told, type EventFilter } from '@/operate/event_filter';
import { useNews } from '@/operate/use_live';
import { group_of, is_grave, kGroups, words_of_event } from '@/operate/words_of_event';

const kRow_px = 28;
const kMoreRows = 6;

interface Props {
  live: LiveRun;
  filter: EventFilter;
  select: (robot: number) => void;
  /** To an event's moment, of a recorded run. */
  jump?: ((time_s: number) => void) | undefined;
}

interface RowProps {
  tick_s: number;
  select: (robot: number) => void;
  jump: ((time_s: number) => void) | undefined;
  now_s: number;
}

/** The newest stay in sight until somebody scrolls up. */
export function EventsPanel({ live, filter, select, jump }: Props) {
  const news = useNews(live);
  const { groups, words, checkpoints } = filter;
  // The log grows in place; `news` says that it may have.
  // eslint-disable-next-line react-hooks/exhaustive-deps
  const all = useMemo(() => told(live.log, checkpoints), [live, news, checkpoints]);
  // eslint-disable-next-line react-hooks/exhaustive-deps
  const shown = useMemo(() => listed(live.log, filter), [live, news, groups, words, checkpoints]);
  const newest = all[all.length - 1];
  return (
    <section className="panel events" aria-label="Events">
      <header className="panel-head">
        <h2>Events</h2>
        <div className="row" role="group" aria-label="Which events">
          {kGroups.map((group) => (
            <button key={group} type="button" aria-pressed={groups.includes(group)} onClick={() => filter.toggle(group)}>
              {group}
            </button>
          ))}
        </div>
        <input
          type="search" placeholder="Filter, such as robot 3" aria-label="Filter events" value={words}
          onChange={(event) => filter.set_words(event.target.value)}
        />
        <span className="hint">
          {shown.length} of {all.length}
          {jump ? ' heard so far' : ''}
          {live.missed_events > 0 && !jump ? `, ${live.missed_events} were missed` : ''}
        </span>
      </header>
      <Rows events={shown} tick_s={live.tick_s} select={select} jump={jump} now_s={live.time_s} />
      <Announcer text={newest ? `Event ${newest.index + 1}: ${words_of_event(newest.event)}` : ''} />
    </section>
  );
}

function Rows(props: RowProps & { events: readonly LoggedEvent[] }) {
  const { events } = props;
  const box = useRef<HTMLDivElement>(null);
  const [top, set_top] = useState(0);
  const [height, set_height] = useState(160);
  const at_end = useRef(true);
  // Of a recorded run, those after the moment that is shown come below.
  const past = props.jump ? events.filter((one) => !is_later(one, props)).length : events.length;
  useEffect(() => {
    const watch = new ResizeObserver(() => set_height(box.current?.clientHeight ?? 160));
    watch.observe(box.current!);
    return () => watch.disconnect();
  }, []);
  useEffect(() => {
    if (at_end.current && box.current) box.current.scrollTop = end_of(past, box.current);
  }, [past]);
  const scrolled = () => {
    const { scrollTop } = box.current!;
    const away_px = scrollTop - end_of(past, box.current!);
    at_end.current = away_px >= -kRow_px && (!props.jump || away_px <= kRow_px);
    set_top(scrollTop);
  };
  const first = Math.max(0, Math.floor(top / kRow_px) - kMoreRows);
  const last = Math.min(events.length, Math.ceil((top + height) / kRow_px) + kMoreRows);
  return (
    <div
      ref={box} className="rows" role="log" aria-live="off" aria-label="Event log" tabIndex={0}
      onScroll={scrolled}
    >
      {events.length === 0 && <p className="hint">No event yet that fits.{props.jump ? ' Play on to hear of some.' : ''}</p>}
      <div style={{ height: `${events.length * kRow_px}px` }} className="rows-all">
        {events.slice(first, last).map((logged, i) => (
          <Row key={logged.index} logged={logged} top_px={(first + i) * kRow_px} {...props} />
        ))}
      </div>
    </div>
  );
}

function end_of(rows: number, box: HTMLElement): number {
  return Math.max(0, rows * kRow_px - box.clientHeight);
}

function is_later({ event }: LoggedEvent, { tick_s, now_s }: RowProps): boolean {
  return Number(event.tick) * tick_s > now_s + 1e-3;
}

function Row(props: RowProps & { logged: LoggedEvent; top_px: number }) {
  const { event } = props.logged;
  const { jump } = props;
  const group = group_of(event);
  const time_s = Number(event.tick) * props.tick_s;
  const later = jump && is_later(props.logged, props);
  return (
    <div className={`event ${group} ${is_grave(event) ? 'grave' : ''} ${later ? 'later' : ''}`} style={{ top: `${props.top_px}px` }}>
      {jump ? (
        <button type="button" className="quiet at" aria-label={`Go to ${clock(time_s)}`} onClick={() => jump(time_s)}>
          <time>{clock(time_s)}</time>
        </button>
      ) : (
        <time>{clock(time_s)}</time>
      )}
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
