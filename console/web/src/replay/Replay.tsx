import { api } from '@/api/client';
import type { Run } from '@/api/types';
import { useAsked } from '@/api/use';
import { Loading, Nothing, Trouble } from '@/app/parts';
import { address_of } from '@/app/route';
import type { LiveRun } from '@/live/live_run';
import { useEventFilter } from '@/operate/event_filter';
import { LinkBanner } from '@/operate/LinkBanner';
import { useNews } from '@/operate/use_live';
import { Watched } from '@/operate/Watched';
import { ReplayControls } from '@/replay/ReplayControls';
import { usePlayer } from '@/replay/use_player';
import { useMoment, useReplay } from '@/replay/use_replay';
import '@/replay/replay.css';

/** A recorded run, played as a live one is shown. */
export default function Replay({ run: id }: { run: string }) {
  const run = useAsked(() => api.run(id), `run ${id}`);
  if (!id) return <NoRecording title="No run was named" />;
  if (run.error) return <Trouble text={run.error} again={run.again} />;
  if (!run.value) return <Loading what="the run" />;
  if (!run.value.recording) return <NoRecording title={`${run.value.name || id} has no recording`} />;
  return <Open run={run.value} />;
}

function NoRecording({ title }: { title: string }) {
  return (
    <Nothing title={title}>
      <p>
        A run can be played when it was recorded: <code>tacit run --record</code>. Runs that are started here
        are.
      </p>
      <a className="button primary" href={address_of('results')}>
        All runs
      </a>
    </Nothing>
  );
}

function Open({ run }: { run: Run }) {
  const { live, error, again } = useReplay(run.id);
  if (error) return <Trouble text={`The recording cannot be played: ${error}`} again={again} />;
  if (!live) return <Loading what="the recording" />;
  return <Played run={run} live={live} again={again} />;
}

function Played({ run, live, again }: { run: Run; live: LiveRun; again: () => void }) {
  const scene = useAsked(() => api.run_scene(run.id), `scene ${run.id}`);
  const filter = useEventFilter(Boolean(scene.value?.target));
  const player = usePlayer(live, filter);
  useNews(live);
  useMoment(player.go, live.playing !== null && live.link === 'open');
  const reopen = () => {
    history.replaceState(null, '', address_of('replay', run.id, player.time_s()));
    again();
  };
  const acts = {
    ' ': player.toggle,
    '.': player.step,
    '+': player.faster,
    '=': player.faster,
    '-': player.slower,
    j: () => player.to_event(-1),
    k: () => player.to_event(1),
  };
  return (
    <section className="replay" aria-label="Recorded run">
      <Watched live={live} name={run.name || run.id} scene={scene} filter={filter} acts={acts} jump={player.go}>
        <LinkBanner live={live} retry={reopen} />
        <ReplayControls live={live} run={run} player={player} filter={filter} />
      </Watched>
    </section>
  );
}
