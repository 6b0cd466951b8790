import { useEffect, useRef, useState } from 'react';

import type { Scene } from '@/api/types';
import { Loading } from '@/app/parts';
import { useSettings } from '@/app/settings';
import type { LiveRun } from '@/live/live_run';
import { Camera } from '@/map/camera';
import { MapView, type MapHandle } from '@/map/MapView';
import { draw_live } from '@/operate/draw_live';
import { Glyphs, Legend } from '@/operate/glyphs';
import { LiveLayer } from '@/operate/live_layer';
import { useNews } from '@/operate/use_live';

interface LiveMapProps {
  live: LiveRun;
  handle: React.RefObject<MapHandle | null>;
  scene: Scene | null;
  selected: number | null;
  select: (robot: number | null) => void;
  follow: boolean;
  step_robot: (by: number) => void;
  name: string;
}

/** What moves in a run, on its scene. */
export function LiveMap(props: LiveMapProps) {
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
