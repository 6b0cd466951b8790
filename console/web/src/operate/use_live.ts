import { useEffect, useState, useSyncExternalStore } from 'react';

import { socket_of, words_of } from '@/api/client';
import { LiveRun } from '@/live/live_run';

/** Watches a run as long as the view is there. */
export function useLive(run: string): LiveRun | null {
  const [live, set_live] = useState<LiveRun | null>(null);
  useEffect(() => {
    const watched = new LiveRun(socket_of(run));
    set_live(watched);
    watched.start();
    return () => watched.stop();
  }, [run]);
  return live;
}

/** Is drawn anew a few times a second, while there is something new. */
export function useNews(live: LiveRun): number {
  return useSyncExternalStore(live.on_news, live.version);
}

export interface Calls {
  /** Why the last one was not done; empty when it was. */
  error: string;
  set_error: (text: string) => void;
  /** Whether it was done. */
  call: (service: string, request?: object) => Promise<boolean>;
}

/** Calls of the run's services. */
export function useCalls(live: LiveRun): Calls {
  const [error, set_error] = useState('');
  const call = async (service: string, request: object = {}) => {
    try {
      await live.call(service, request);
      set_error('');
      return true;
    } catch (thrown) {
      set_error(`"${service}" was not done: ${words_of(thrown)}`);
      return false;
    }
  };
  return { error, set_error, call };
}
