import { useSyncExternalStore } from 'react';

export type View = 'operate' | 'plan' | 'results' | 'replay';

/** `#/operate/RUN`, `#/plan`, `#/results/RUN`, `#/replay/RUN?t=SECONDS`. */
export interface Route {
  view: View;
  run: string;
  /** The moment of a recording. */
  time_s: number | null;
}

const kViews: readonly View[] = ['operate', 'plan', 'results', 'replay'];

export function route_of(hash: string): Route {
  const [path = '', query = ''] = hash.replace(/^#/, '').split('?');
  const [, named = '', run = ''] = path.split('/');
  const text = new URLSearchParams(query).get('t')?.trim() || null;
  const time_s = text === null ? NaN : Number(text);
  return {
    view: kViews.find((view) => view === named) ?? 'operate',
    run: decoded(run),
    time_s: Number.isFinite(time_s) && time_s >= 0 ? time_s : null,
  };
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

export function address_of(view: View, run = '', time_s: number | null = null): string {
  const moment = time_s === null ? '' : `?t=${Number(time_s.toFixed(1))}`;
  return `#/${view}${run ? `/${encodeURIComponent(run)}` : ''}${moment}`;
}

export function go(view: View, run = ''): void {
  location.hash = address_of(view, run);
}

export function useRoute(): Route {
  const hash = useSyncExternalStore(
    (changed) => {
      window.addEventListener('hashchange', changed);
      return () => window.removeEventListener('hashchange', changed);
    },
    () => location.hash,
  );
  return route_of(hash);
}
