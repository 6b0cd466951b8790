import { create } from 'zustand';

import { keep, recall } from '@/app/kept';

export type Theme = 'system' | 'light' | 'dark';

export interface Settings {
  theme: Theme;
  /** Letters alone do something (WCAG 2.1.4 wants a way to turn this off). */
  keys: boolean;
  trails: boolean;
  trail_s: number;
  vectors: boolean;
  sensors: boolean;
  sensor_m: number;
  labels: boolean;
  set: (change: Partial<Settings>) => void;
}

const kDefaults = {
  theme: 'system' as Theme,
  keys: true,
  trails: true,
  trail_s: 60,
  vectors: true,
  sensors: false,
  sensor_m: 10,
  labels: true,
};

export const useSettings = create<Settings>((set) => ({
  ...kDefaults,
  ...recall<Partial<Settings>>('settings', {}),
  set: (change) => set(change),
}));

useSettings.subscribe(({ set: _, ...settings }) => void keep('settings', settings));

export function show_theme(theme: Theme): void {
  if (theme === 'system') delete document.documentElement.dataset['theme'];
  else document.documentElement.dataset['theme'] = theme;
}
