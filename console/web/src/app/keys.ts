import { useEffect, useRef } from 'react';

import { useSettings } from '@/app/settings';

export interface Shortcut {
  shown: string;
  does: string;
}

/** Of a run that is watched, in the order of the help. */
export const kOperateKeys: Shortcut[] = [
  { shown: 'Space', does: 'Pause or go on' },
  { shown: '.', does: 'One tick' },
  { shown: '+', does: 'Faster' },
  { shown: '-', does: 'Slower' },
  { shown: 'F', does: 'Fit the map into the window' },
  { shown: 'N', does: 'Next robot' },
  { shown: 'P', does: 'Previous robot' },
  { shown: 'L', does: 'Follow the selected robot' },
  { shown: 'T', does: 'Trails' },
  { shown: 'V', does: 'Pushes of the motor schemas' },
  { shown: 'S', does: 'Sensor range' },
  { shown: 'Esc', does: 'Select no robot' },
];

export const kReplayKeys: Shortcut[] = [
  { shown: 'J, K', does: 'To the event before, after' },
  { shown: '← →', does: 'On the time bar: 1 s back, on' },
  { shown: 'Page Up, Page Down', does: 'On the time bar: 10 s on, back' },
  { shown: 'Home, End', does: 'On the time bar: its ends' },
];

export const kMapKeys: Shortcut[] = [
  { shown: '← ↑ → ↓', does: 'Move the map (when it has the focus)' },
  { shown: 'Page Up, Page Down', does: 'Zoom (when the map has the focus)' },
];

export const kPlanKeys: Shortcut[] = [
  { shown: 'Ctrl+Z, Ctrl+Shift+Z', does: 'Undo, redo' },
  { shown: '← ↑ → ↓', does: 'Move the focused task by 1 m; with Shift by 10 m' },
  { shown: 'Delete', does: 'Remove the focused task' },
  { shown: 'Alt+↑, Alt+↓', does: 'Earlier or later in the order' },
];

/** Whether a key belongs to what has the focus: letters to a field, Space to a button. */
function is_taken(event: KeyboardEvent): boolean {
  const target = event.target;
  if (!(target instanceof Element)) return false;
  const dialog = target.closest('dialog');
  // A dialog that was just closed may have the focus still.
  if (dialog) return dialog.open;
  if (target.closest('input, select, textarea, [contenteditable]')) {
    if (!(target instanceof HTMLInputElement)) return true;
    // A slider moves by keys of its own, which are no letters.
    return target.type !== 'range' && !(target.type === 'checkbox' && event.key !== ' ');
  }
  return event.key === ' ' && target.closest('button, a, summary, [role=option]') !== null;
}

/** Calls `act` with a key's own spelling from `wanted`, unless something else has it. */
export function useKeys(wanted: readonly string[], act: (key: string) => void): void {
  const newest = useRef({ wanted, act });
  newest.current = { wanted, act };
  useEffect(() => {
    const pressed = (event: KeyboardEvent) => {
      if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
      if (!useSettings.getState().keys && event.key !== 'Escape') return;
      const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
      if (!newest.current.wanted.includes(key) || is_taken(event)) return;
      event.preventDefault();
      newest.current.act(key);
    };
    window.addEventListener('keydown', pressed);
    return () => window.removeEventListener('keydown', pressed);
  }, []);
}
