import { useEffect, useState } from 'react';

import type { LiveRun } from '@/live/live_run';
import { useNews } from '@/operate/use_live';

/** How it stands with the connection, when a person should know. */
export function LinkBanner({ live, retry }: { live: LiveRun; retry?: () => void }) {
  useNews(live);
  const [was_open, set_was_open] = useState(false);
  useEffect(() => {
    if (live.link === 'open') set_was_open(true);
  }, [live.link]);
  if (live.over) {
    return (
      <div className="banner good" role="status">
        The run has {live.phase === 'ended' ? 'ended' : 'been stopped'}. The map shows how it stood last.
      </div>
    );
  }
  if (live.link === 'waiting' || (live.link === 'connecting' && was_open)) {
    return (
      <div className="banner bad" role="alert">
        <span aria-hidden="true">⚠ </span>
        {was_open ? 'The connection was lost' : 'The run cannot be reached'}; trying again. What is shown is
        old.
        <button type="button" onClick={retry ?? (() => live.retry())}>
          Try now
        </button>
      </div>
    );
  }
  if (live.stale) {
    return (
      <div className="banner" role="status">
        <span aria-hidden="true">⏳ </span>Nothing came for more than 1 s: what is shown is old.
      </div>
    );
  }
  if (live.trouble) {
    return (
      <div className="banner" role="status">
        <span aria-hidden="true">⚠ </span>
        {live.trouble}
      </div>
    );
  }
  return null;
}
