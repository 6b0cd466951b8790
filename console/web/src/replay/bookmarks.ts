import type { LoggedEvent } from '@/live/live_run';
import { is_checkpoint, is_grave } from '@/operate/words_of_event';

/** A moment at which something happened. */
export interface Bookmark {
  time_s: number;
  grave: boolean;
}

const kSame_s = 1e-3;

/** Of the events that are listed, one for each moment, in their order. */
export function bookmarks_of(events: readonly LoggedEvent[], tick_s: number): Bookmark[] {
  const marks: Bookmark[] = [];
  for (const { event } of events) {
    if (is_checkpoint(event)) continue;
    const time_s = Number(event.tick) * tick_s;
    const last = marks[marks.length - 1];
    if (last && time_s - last.time_s < kSame_s) last.grave ||= is_grave(event);
    else marks.push({ time_s, grave: is_grave(event) });
  }
  return marks;
}

/** The one before or after a moment; `near_s` and less before it does not count. */
export function neighbour(marks: readonly Bookmark[], time_s: number, by: -1 | 1, near_s = 0): Bookmark | undefined {
  if (by > 0) return marks.find((mark) => mark.time_s > time_s + kSame_s);
  return [...marks].reverse().find((mark) => mark.time_s < time_s - near_s - kSame_s);
}
