import { useSyncExternalStore } from 'react';

export type View = 'operate' | 'plan' | 'results';

/** `#/operate/RUN`, `#/plan`, `#/results/RUN`. */
export interface Route {
  view: View;
  run: string;
}

export function route_of(hash: string): Route {
  const [, view = '', run = ''] = hash.replace(/^#/, '').split('/');
  const known = view === 'plan' || view === 'results' ? view : 'operate';
  return { view: known, run: decodeURIComponent(run) };
}

export function address_of(view: View, run = ''): string {
  return `#/${view}${run ? `/${encodeURIComponent(run)}` : ''}`;
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
