import { useState } from 'react';

import type { LoggedEvent } from '@/live/live_run';
import { group_of, is_checkpoint, kGroups, words_of_event, type Group } from '@/operate/words_of_event';

/** Which events are listed. */
export interface EventFilter {
  groups: readonly Group[];
  words: string;
  /** Those of a run that guards a target. */
  checkpoints: boolean;
  toggle: (group: Group) => void;
  set_words: (words: string) => void;
}

export function useEventFilter(checkpoints: boolean): EventFilter {
  const [groups, set_groups] = useState<readonly Group[]>(kGroups);
  const [words, set_words] = useState('');
  const toggle = (group: Group) =>
    set_groups(groups.includes(group) ? groups.filter((one) => one !== group) : [...groups, group]);
  return { groups, words, checkpoints, toggle, set_words };
}

export function matches(logged: LoggedEvent, groups: readonly Group[], robot: number | null, words: string): boolean {
  const { event } = logged;
  if (!groups.includes(group_of(event))) return false;
  if (robot !== null && event.robot !== robot && event.other_robot !== robot) return false;
  return words === '' || words_of_event(event).toLowerCase().includes(words.toLowerCase());
}

/** Without those that say nothing in a run of this kind. */
export function told(log: readonly LoggedEvent[], checkpoints: boolean): readonly LoggedEvent[] {
  return checkpoints ? log : log.filter(({ event }) => !is_checkpoint(event));
}

export function listed(log: readonly LoggedEvent[], filter: EventFilter): readonly LoggedEvent[] {
  const { groups, words, checkpoints } = filter;
  return told(log, checkpoints).filter((logged) => matches(logged, groups, null, words));
}
