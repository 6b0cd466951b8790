import { useEffect, useRef, useState } from 'react';

import { api } from '@/api/client';
import type { Run } from '@/api/types';
import { useAsked } from '@/api/use';
import { kOperateKeys, useKeys } from '@/app/keys';
import { Loading, Trouble } from '@/app/parts';
import { useSettings } from '@/app/settings';
import type { LiveRun } from '@/live/live_run';
import { Camera } from '@/map/camera';
import { MapView, type MapHandle } from '@/map/MapView';
import { Controls, useControls } from '@/operate/Controls';
import { draw_live } from '@/operate/draw_live';
import { EventsPanel } from '@/operate/EventsPanel';
import { Glyphs, Legend } from '@/operate/glyphs';
import { HealthPanel } from '@/operate/HealthPanel';
import { Inspector } from '@/operate/Inspector';
import { Layers } from '@/operate/Layers';
import { LiveLayer } from '@/operate/live_layer';
import { useLive, useNews } from '@/operate/use_live';

const kKeys = kOperateKeys.flatMap((key) => key.keys);

export function LiveView({ run }: { run: Run }) {
  const live = useLive(run.id);
  return live ? <Watched run={run} live={live} /> : <Loading what="the run" />;
}

function Watched({ run, live }: { run: Run; live: LiveRun }) {
  const [selected, select] = useState<number | null>(null);
  const [follow, set_follow] = useState(false);
  const scene = useAsked(() => api.run_scene(run.id), `scene ${run.id}`);
  const controls = useControls(live);
  const map = useRef<MapHandle>(null);
  const settings = useSettings();

  const step_robot = (by: number) => {
    const all = (live.view?.robots ?? []).map((robot) => robot.robot);
    if (all.length === 0) return;
    const now = selected === null ? (by > 0 ? -1 : 0) : all.indexOf(selected);
    select(all[(now + by + all.length) % all.length]!);
  };
  const toggle_follow = () => set_follow(!follow && selected !== null);
  const acts: Record<string, () => void> = {
    ' ': controls.toggle,
    '.': controls.step,
    '+': controls.faster,
    '=': controls.faster,
    '-': controls.slower,
    f: () => map.current?.fit(),
    n: () => step_robot(1),
    p: () => step_robot(-1),
    l: toggle_follow,
    t: () => settings.set({ trails: !settings.trails }),
    v: () => settings.set({ vectors: !settings.vectors }),
    s: () => settings.set({ sensors: !settings.sensors }),
    Escape: () => {
      select(null);
      set_follow(false);
    },
  };
  useKeys(kKeys, (key) => acts[key]?.());

  return (
    <div className="watched">
      <LinkBanner live={live} />
      <Controls live={live} controls={controls} run={run} />
      <div className="watched-body">
        <div className="watched-map">
          {scene.error && <Trouble text={`No map: ${scene.error}`} again={scene.again} />}
          <LiveMap
            live={live}
            handle={map}
            scene={scene.value}
            selected={selected}
            select={select}
            follow={follow}
            step_robot={step_robot}
            name={run.name || run.id}
          />
          <Layers live={live} follow={follow} toggle_follow={toggle_follow} can_follow={selected !== null} />
        </div>
        <aside className="panel side" aria-label="Robot and agents">
          <Inspector live={live} robot={selected} select={select} />
          <HealthPanel live={live} select={select} />
        </aside>
      </div>
      <EventsPanel live={live} select={select} />
    </div>
  );
}

function LinkBanner({ live }: { live: LiveRun }) {
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
        <button type="button" onClick={() => live.retry()}>
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

interface LiveMapProps {
  live: LiveRun;
  handle: React.RefObject<MapHandle | null>;
  scene: import('@/api/types').Scene | null;
  selected: number | null;
  select: (robot: number | null) => void;
  follow: boolean;
  step_robot: (by: number) => void;
  name: string;
}

function LiveMap(props: LiveMapProps) {
  const { live, handle, selected } = props;
  const [camera] = useState(() => new Camera());
  const things = useRef<SVGGElement>(null);
  const robots = useRef<SVGGElement>(null);
  const layer = useRef<LiveLayer | null>(null);
  const settings = useSettings();
  useNews(live);

  useEffect(() => {
    layer.current = new LiveLayer(things.current!, robots.current!);
  }, []);
  const following = useRef<number | null>(null);
  following.current = props.follow ? selected : null;
  useEffect(
    () =>
      live.on_frame(() => {
        const robot = following.current === null ? null : live.robots.get(following.current);
        if (robot) camera.look_at(robot.x_m, robot.y_m);
        handle.current?.redraw();
      }),
    [live, camera, handle],
  );

  const choose = (event: React.SyntheticEvent) => {
    const number = (event.target as Element).closest('[data-robot]')?.getAttribute('data-robot');
    if (number) props.select(Number(number));
    return number !== undefined && number !== null;
  };
  const pressed = (event: React.KeyboardEvent) => {
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (by) {
      event.preventDefault();
      props.step_robot(by);
    } else if (event.key === 'Enter' || event.key === ' ') {
      if (choose(event)) event.preventDefault();
    }
  };
  // The focus goes with the choice as long as it is among the robots.
  useEffect(() => {
    if (selected !== null && robots.current?.contains(document.activeElement)) {
      layer.current?.focus(selected);
    }
  }, [selected]);

  const look = { ...settings, selected };
  return (
    <MapView
      ref={handle}
      camera={camera}
      label={`Map of ${props.name}. Arrow keys move it, Page Up and Page Down zoom.`}
      scene={props.scene}
      className={live.stale ? 'stale' : ''}
      draw={(pen, colours) => draw_live(pen, camera, live, look, colours)}
      place={() => layer.current?.show(live, camera, look)}
      on_click={() => props.select(null)}
      over={
        <>
          <Legend />
          {!live.view && !live.over && (
            <div className="map-wait">
              <Loading what="the world" />
            </div>
          )}
        </>
      }
    >
      <Glyphs />
      <g ref={things} />
      <g ref={robots} role="listbox" aria-label="Robots" onClick={choose} onKeyDown={pressed} />
    </MapView>
  );
}

