import type { Run } from '@/api/types';
import { address_of } from '@/app/route';
import type { LiveRun } from '@/live/live_run';
import { Fact } from '@/operate/Controls';
import type { EventFilter } from '@/operate/event_filter';
import { PlayAndSpeed } from '@/operate/PlayAndSpeed';
import { useNews } from '@/operate/use_live';
import { Scrubber } from '@/replay/Scrubber';
import { kSpeeds, useWrittenMoment, type Player } from '@/replay/use_player';

interface Props {
  live: LiveRun;
  run: Run;
  player: Player;
  filter: EventFilter;
}

/** Play, step, speed, time and events of a recorded run. */
export function ReplayControls({ live, run, player, filter }: Props) {
  useNews(live);
  useWrittenMoment(live, (time_s) => address_of('replay', run.id, time_s));
  const { paused, status } = live;
  const dead = live.link !== 'open' || !live.playing;
  const speed = player.speed();
  const speeds = kSpeeds.includes(speed) ? kSpeeds : [...kSpeeds, speed].sort((a, b) => a - b);
  const phase = paused ? (player.at_end() ? 'at its end' : 'paused') : 'playing';
  return (
    <header className="controls replay-controls">
      <div className="run-title">
        <h1>Replay of {run.name || run.id}</h1>
        <span className={`phase ${paused ? 'paused' : 'running'}`}>{live.playing ? phase : 'opening'}</span>
        <a href={address_of('results', run.id)}>Results</a>
      </div>
      <div className="row" role="group" aria-label="Recording">
        <PlayAndSpeed
          paused={paused} dead={dead} toggle={player.toggle} step={player.step}
          speed={speed} speeds={speeds} set_speed={player.set_speed}
        />
        <button
          type="button" onClick={() => player.to_event(-1)} disabled={dead} aria-keyshortcuts="J"
          aria-label="Event before"
        >
          <span aria-hidden="true">◀</span> Event
        </button>
        <button
          type="button" onClick={() => player.to_event(1)} disabled={dead} aria-keyshortcuts="K"
          aria-label="Event after"
        >
          Event <span aria-hidden="true">▶</span>
        </button>
      </div>
      <dl className="facts">
        <Fact name="Tick" value={String(live.view?.tick ?? '–')} />
        <Fact name="Robots" value={status ? `${status.present} of ${status.robots}` : '–'} />
      </dl>
      <Scrubber live={live} player={player} filter={filter} />
      {player.error && (
        <p className="controls-error" role="alert">
          <span aria-hidden="true">⚠ </span>
          {player.error}
        </p>
      )}
    </header>
  );
}
