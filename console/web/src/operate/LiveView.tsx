import { api } from '@/api/client';
import type { Run } from '@/api/types';
import { useAsked } from '@/api/use';
import { Loading } from '@/app/parts';
import type { LiveRun } from '@/live/live_run';
import { Controls, useControls } from '@/operate/Controls';
import { useEventFilter } from '@/operate/event_filter';
import { LinkBanner } from '@/operate/LinkBanner';
import { useLive } from '@/operate/use_live';
import { Watched } from '@/operate/Watched';

export function LiveView({ run }: { run: Run }) {
  const live = useLive(run.id);
  return live ? <WatchedLive run={run} live={live} /> : <Loading what="the run" />;
}

function WatchedLive({ run, live }: { run: Run; live: LiveRun }) {
  const scene = useAsked(() => api.run_scene(run.id), `scene ${run.id}`);
  const filter = useEventFilter(Boolean(scene.value?.target));
  const controls = useControls(live);
  const acts = {
    ' ': controls.toggle,
    '.': controls.step,
    '+': controls.faster,
    '=': controls.faster,
    '-': controls.slower,
  };
  return (
    <Watched live={live} name={run.name || run.id} scene={scene} filter={filter} acts={acts} operator>
      <LinkBanner live={live} />
      <Controls live={live} controls={controls} run={run} />
    </Watched>
  );
}
