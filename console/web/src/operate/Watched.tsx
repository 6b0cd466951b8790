import { useRef, useState, type ReactNode } from 'react';

import type { Scene } from '@/api/types';
import type { Asked } from '@/api/use';
import { useKeys } from '@/app/keys';
import { Trouble } from '@/app/parts';
import { useSettings } from '@/app/settings';
import type { LiveRun } from '@/live/live_run';
import type { MapHandle } from '@/map/MapView';
import type { EventFilter } from '@/operate/event_filter';
import { EventsPanel } from '@/operate/EventsPanel';
import { HealthPanel } from '@/operate/HealthPanel';
import { Inspector } from '@/operate/Inspector';
import { Layers } from '@/operate/Layers';
import { LiveMap } from '@/operate/LiveMap';

interface Props {
  live: LiveRun;
  name: string;
  scene: Asked<Scene>;
  filter: EventFilter;
  /** Keys of the controls. */
  acts: Record<string, () => void>;
  operator?: boolean;
  jump?: (time_s: number) => void;
  /** Banner and controls. */
  children: ReactNode;
}

/** A run, live or recorded: its map, a robot, the agents, the events. */
export function Watched(props: Props) {
  const { live, scene } = props;
  const [selected, select] = useState<number | null>(null);
  const [follow, set_follow] = useState(false);
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
    ...props.acts,
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
  useKeys(Object.keys(acts), (key) => acts[key]?.());

  return (
    <div className="watched">
      {props.children}
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
            name={props.name}
          />
          <Layers live={live} follow={follow} toggle_follow={toggle_follow} can_follow={selected !== null} />
        </div>
        <aside className="panel side" aria-label="Robot and agents">
          <Inspector live={live} robot={selected} select={select} operator={props.operator ?? false} />
          <HealthPanel live={live} select={select} />
        </aside>
      </div>
      <EventsPanel live={live} filter={props.filter} select={select} jump={props.jump} />
    </div>
  );
}
