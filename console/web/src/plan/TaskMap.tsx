import { useRef, useState, type DragEvent, type KeyboardEvent, type PointerEvent } from 'react';

import type { Scene, TaskKind } from '@/api/types';
import { Camera } from '@/map/camera';
import { MapView, useCamera, type MapHandle } from '@/map/MapView';
import type { Problem } from '@/plan/check';
import { change, kTasks, name_of, type DraftTask } from '@/plan/draft';
import { useDraft } from '@/plan/store';

const kArrows: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
};
const kFar = 10;

interface Props {
  scene: Scene;
  selected: number | null;
  select: (task: number | null) => void;
  /** In the map's frame. */
  place: (x: number, y: number) => void;
  problems: Problem[];
  tool: TaskKind | null;
}

export function TaskMap(props: Props) {
  const { scene, place } = props;
  const [camera] = useState(() => new Camera());
  const map = useRef<MapHandle>(null);
  const dropped = (event: DragEvent) => {
    const kind = event.dataTransfer.getData('text/tacit-task') as TaskKind;
    if (!kind) return;
    event.preventDefault();
    const box = event.currentTarget.getBoundingClientRect();
    const [x, y] = camera.to_world(event.clientX - box.left, event.clientY - box.top);
    useDraft.getState().change((now) => change.add(now, kind, x - scene.shift.x, y - scene.shift.y));
  };
  return (
    <div className="task-map" onDragOver={(event) => event.preventDefault()} onDrop={dropped}>
      <MapView
        ref={map}
        camera={camera}
        scene={scene}
        className={props.tool ? 'placing' : ''}
        label={`Map of ${scene.name}. ${
          props.tool ? `A click places a task: ${name_of(props.tool)}.` : 'A click selects.'
        } Arrow keys move the map.`}
        on_click={(x, y) => place(x - scene.shift.x, y - scene.shift.y)}
      >
        <Tasks {...props} camera={camera} />
      </MapView>
    </div>
  );
}

function Tasks(props: Props & { camera: Camera }) {
  const { camera, scene } = props;
  const tasks = useDraft((state) => state.tasks);
  useCamera(camera);
  const at = (task: { x: number; y: number }) => camera.to_screen(task.x + scene.shift.x, task.y + scene.shift.y);
  const way = tasks.map((task) => at(task).join()).join(' ');
  return (
    <g>
      <polyline className="task-way" points={way} />
      {tasks.map((task, i) => (
        <TaskPin key={task.id} {...props} task={task} number={i + 1} />
      ))}
    </g>
  );
}

/** One task on the map. It is dragged as a ghost; the description changes once, when it is let go. */
function TaskPin(props: Props & { camera: Camera; task: DraftTask; number: number }) {
  const { camera, scene, task, number, selected, select } = props;
  const [ghost, set_ghost] = useState<[number, number] | null>(null);
  const from = useRef<[number, number] | null>(null);
  const set = useDraft((state) => state.change);
  const [x, y] = ghost ?? camera.to_screen(task.x + scene.shift.x, task.y + scene.shift.y);
  const worst = props.problems.filter((problem) => problem.task === task.id).map((problem) => problem.level);
  const level = worst.includes('error') ? 'error' : worst.includes('warning') ? 'warning' : '';
  const local = (event: PointerEvent): [number, number] => {
    const box = (event.currentTarget as SVGElement).ownerSVGElement!.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const let_go = () => {
    from.current = null;
    if (!ghost) return;
    const [wx, wy] = camera.to_world(...ghost);
    set_ghost(null);
    set((now) => change.move(now, task.id, wx - scene.shift.x, wy - scene.shift.y));
  };
  const pressed = (event: KeyboardEvent) => act_on_key(event, task, set, select);
  return (
    <g className="pin-place" transform={`translate(${x} ${y})`}>
      <g
        className={`pin ${task.task} ${level} ${ghost ? 'ghost' : ''}`}
        role="button"
        tabIndex={0}
        data-own-pointer=""
        data-task={task.id}
        aria-pressed={task.id === selected}
        aria-label={`Task ${number}, ${name_of(task.task)}, at ${task.x}, ${task.y} metres${level ? `, ${level}` : ''}`}
        onFocus={() => select(task.id)}
        onKeyDown={pressed}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          from.current = local(event);
          select(task.id);
        }}
        onPointerMove={(event) => {
          const start = from.current;
          if (!start) return;
          const now = local(event);
          if (ghost || Math.hypot(now[0] - start[0], now[1] - start[1]) > 3) set_ghost(now);
        }}
        onPointerUp={let_go}
        onPointerCancel={() => {
          from.current = null;
          set_ghost(null);
        }}
      >
        <circle className="halo" r="19" />
        <circle className="body" r="14" />
      </g>
      <text className="pin-letter" aria-hidden="true" y="5" textAnchor="middle">
        {kTasks.find((one) => one.kind === task.task)?.letter}
      </text>
      <text className="pin-number" aria-hidden="true" x="14" y="-10">
        {number}
        {level && (level === 'error' ? ' ✕' : ' ⚠')}
      </text>
    </g>
  );
}

function act_on_key(
  event: KeyboardEvent, task: DraftTask, set: ReturnType<typeof useDraft.getState>['change'],
  select: (task: number | null) => void,
): void {
  const arrow = kArrows[event.key];
  const by = event.shiftKey ? kFar : 1;
  if (event.altKey && (event.key === 'ArrowUp' || event.key === 'ArrowDown')) {
    set((now) => change.reorder(now, task.id, event.key === 'ArrowUp' ? -1 : 1));
  } else if (arrow && !event.ctrlKey && !event.metaKey) {
    set((now) => change.move(now, task.id, task.x + by * arrow[0], task.y + by * arrow[1]), `move ${task.id}`);
  } else if (event.key === 'Delete') {
    set((now) => change.remove(now, task.id));
    select(null);
  } else {
    return;
  }
  event.preventDefault();
}
