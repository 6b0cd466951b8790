import { useEffect, useState } from 'react';

import { api, socket_of, words_of } from '@/api/client';
import { route_of } from '@/app/route';
import { LiveRun } from '@/live/live_run';

/** What is asked of the console, in turn: a recording that is left and come back to at once is not
 * closed after it was opened. */
let turn: Promise<unknown> = Promise.resolve();

function in_turn<T>(ask: () => Promise<T>): Promise<T> {
  const asked = turn.then(ask);
  turn = asked.catch(() => {});
  return asked;
}

export interface Opened {
  live: LiveRun | null;
  error: string;
  /** Opens it anew. */
  again: () => void;
}

/** Plays a recorded run as long as the view is there. */
export function useReplay(run: string): Opened {
  const [state, set_state] = useState<{ live: LiveRun | null; error: string }>({ live: null, error: '' });
  const [round, set_round] = useState(0);
  useEffect(() => {
    let left = false;
    let live: LiveRun | null = null;
    const open = async () => {
      try {
        const { id } = await in_turn(() => api.open_replay(run));
        if (left) return;
        live = new LiveRun(socket_of(id), undefined, true);
        set_state({ live, error: '' });
        live.start();
      } catch (error) {
        if (!left) set_state({ live: null, error: words_of(error) });
      }
    };
    const close = () => api.close_replay(run).catch(() => {});
    const gone = () => void close();
    void open();
    window.addEventListener('pagehide', gone);
    return () => {
      left = true;
      window.removeEventListener('pagehide', gone);
      live?.stop();
      void in_turn(close);
    };
  }, [run, round]);
  const again = () => {
    set_state({ live: null, error: '' });
    set_round((n) => n + 1);
  };
  return { ...state, again };
}

/** The moment that the address names, at first and whenever somebody changes it. */
export function useMoment(go: (time_s: number) => void, ready: boolean): void {
  useEffect(() => {
    if (!ready) return;
    const moment = () => {
      const { time_s } = route_of(location.hash);
      if (time_s !== null) go(time_s);
    };
    moment();
    window.addEventListener('hashchange', moment);
    return () => window.removeEventListener('hashchange', moment);
    // `go` does the same each time.
    // eslint-disable-next-line react-hooks/exhaustive-deps
  }, [ready]);
}
