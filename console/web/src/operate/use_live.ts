import { useEffect, useState, useSyncExternalStore } from 'react';

import { socket_of } from '@/api/client';
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
