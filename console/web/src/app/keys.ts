import { useEffect, useRef } from 'react';

import { useSettings } from '@/app/settings';

export interface Shortcut {
  keys: string[];
  shown: string;
  does: string;
}

/** Of the live view, in the order of the help. */
export const kOperateKeys: Shortcut[] = [
  { keys: [' '], shown: 'Space', does: 'Pause or go on' },
  { keys: ['.'], shown: '.', does: 'One tick' },
  { keys: ['+', '='], shown: '+', does: 'Faster' },
  { keys: ['-'], shown: '-', does: 'Slower' },
  { keys: ['f'], shown: 'F', does: 'Fit the map into the window' },
  { keys: ['n'], shown: 'N', does: 'Next robot' },
  { keys: ['p'], shown: 'P', does: 'Previous robot' },
  { keys: ['l'], shown: 'L', does: 'Follow the selected robot' },
  { keys: ['t'], shown: 'T', does: 'Trails' },
  { keys: ['v'], shown: 'V', does: 'Pushes of the motor schemas' },
  { keys: ['s'], shown: 'S', does: 'Sensor range' },
  { keys: ['Escape'], shown: 'Esc', does: 'Select no robot' },
];

export const kMapKeys: Shortcut[] = [
  { keys: [], shown: '← ↑ → ↓', does: 'Move the map (when it has the focus)' },
  { keys: [], shown: 'Page Up, Page Down', does: 'Zoom (when the map has the focus)' },
];

export const kPlanKeys: Shortcut[] = [
  { keys: [], shown: 'Ctrl+Z, Ctrl+Shift+Z', does: 'Undo, redo' },
  { keys: [], shown: '← ↑ → ↓', does: 'Move the focused task by 1 m; with Shift by 10 m' },
  { keys: [], shown: 'Delete', does: 'Remove the focused task' },
  { keys: [], shown: 'Alt+↑, Alt+↓', does: 'Earlier or later in the order' },
];

/** Whether a key belongs to what has the focus: letters to a field, Space to a button. */
function is_taken(event: KeyboardEvent): boolean {
  const target = event.target;
  if (!(target instanceof Element)) return false;
  const dialog = target.closest('dialog');
  // A dialog that was just closed may have the focus still.
  if (dialog) return dialog.open;
  if (target.closest('input, select, textarea, [contenteditable]')) {
    return !(target instanceof HTMLInputElement && target.type === 'checkbox' && event.key !== ' ');
  }
  return event.key === ' ' && target.closest('button, a, summary, [role=option]') !== null;
}

/** Calls `act` with a key's own spelling from `wanted`, unless something else has it. */
export function useKeys(wanted: readonly string[], act: (key: string) => void): void {
  const newest = useRef(act);
  newest.current = act;
  useEffect(() => {
    const pressed = (event: KeyboardEvent) => {
      if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
      if (!useSettings.getState().keys && event.key !== 'Escape') return;
      const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
      if (!wanted.includes(key) || is_taken(event)) return;
      event.preventDefault();
      newest.current(key);
    };
    window.addEventListener('keydown', pressed);
    return () => window.removeEventListener('keydown', pressed);
  }, [wanted]);
}
