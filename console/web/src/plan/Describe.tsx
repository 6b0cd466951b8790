import { useMemo, useState } from 'react';

import { api } from '@/api/client';
import type { Scene, TaskKind } from '@/api/types';
import { useAsked } from '@/api/use';
import { Loading, Nothing, Trouble } from '@/app/parts';
import { problems_of } from '@/plan/check';
import { change, kTasks } from '@/plan/draft';
import { Preferences } from '@/plan/Preferences';
import { Problems } from '@/plan/Problems';
import { useDraft, useHistory, useSession } from '@/plan/store';
import { TaskList } from '@/plan/TaskList';
import { TaskMap } from '@/plan/TaskMap';

/** Step 1: a map, tasks on it in their order, preferences. */
export function Describe() {
  const draft = useDraft();
  const session = useSession();
  const maps = useAsked(api.maps, 'maps');
  const [tool, set_tool] = useState<TaskKind | null>('waypoint');
  const [selected, select] = useState<number | null>(null);
  const scene = useAsked<Scene | null>(
    () => (draft.map ? api.map(draft.map) : Promise.resolve(null)),
    `map ${draft.map}`,
  );
  const problems = useMemo(
    () => problems_of({ map: draft.map, tasks: draft.tasks, preferences: draft.preferences }, scene.value),
    [draft.map, draft.tasks, draft.preferences, scene.value],
  );
  const errors = problems.filter((problem) => problem.level === 'error').length;
  const place = (x: number, y: number) => {
    if (!tool) return select(null);
    draft.change((now) => change.add(now, tool, x, y));
    select(1 + Math.max(0, ...draft.tasks.map((task) => task.id)));
  };
  return (
    <div className="describe">
      <section className="panel describe-form" aria-label="Description">
        <div className="panel-head">
          <h1>Describe the mission</h1>
          <UndoRedo />
        </div>
        <label className="field">
          Map
          <select value={draft.map} onChange={(event) => draft.change((now) => ({ ...now, map: event.target.value }))}>
            <option value="">Choose a map …</option>
            {(maps.value ?? []).map((map) => (
              <option key={map.name}>{map.name}</option>
            ))}
          </select>
        </label>
        {maps.error && <Trouble text={maps.error} again={maps.again} />}
        <TaskList problems={problems} selected={selected} select={select} tool={tool} />
        <Preferences />
      </section>
      <section className="describe-map" aria-label="Map of the mission">
        <Palette tool={tool} set_tool={set_tool} />
        {scene.error && <Trouble text={scene.error} again={scene.again} />}
        {!draft.map && (
          <Nothing title="Choose a map to begin">
            <p>Then click on it to place tasks, or add them by their coordinates.</p>
          </Nothing>
        )}
        {draft.map && !scene.value && !scene.error && <Loading what="the map" />}
        {scene.value && (
          <TaskMap scene={scene.value} selected={selected} select={select} place={place} problems={problems} tool={tool} />
        )}
        <div className="describe-foot">
          <Problems problems={problems} select={select} />
          <button
            type="button" className="primary go" disabled={errors > 0 || !scene.value}
            onClick={() => session.set({ step: 'review' })}
          >
            Review plans <span aria-hidden="true">→</span>
          </button>
        </div>
      </section>
    </div>
  );
}

function UndoRedo() {
  const { undo, redo, pastStates, futureStates } = useHistory();
  return (
    <div className="row" role="group" aria-label="History">
      <button type="button" onClick={() => undo()} disabled={pastStates.length === 0} aria-keyshortcuts="Control+Z">
        <span aria-hidden="true">↶</span> Undo
      </button>
      <button type="button" onClick={() => redo()} disabled={futureStates.length === 0} aria-keyshortcuts="Control+Shift+Z">
        <span aria-hidden="true">↷</span> Redo
      </button>
    </div>
  );
}

function Palette({ tool, set_tool }: { tool: TaskKind | null; set_tool: (tool: TaskKind | null) => void }) {
  return (
    <div className="palette" role="group" aria-label="Task to place on the map">
      <button type="button" aria-pressed={tool === null} onClick={() => set_tool(null)}>
        <svg className="pointer" width="14" height="16" viewBox="0 0 14 16" aria-hidden="true">
          <path d="M1 1V13L4.2 10.2 6.4 15 8.8 13.9 6.6 9.2H11Z" />
        </svg>
        Select
      </button>
      {kTasks.map(({ kind, name, letter, help }) => (
        <button
          key={kind} type="button" aria-pressed={tool === kind} title={help} onClick={() => set_tool(kind)}
          draggable onDragStart={(event) => event.dataTransfer.setData('text/tacit-task', kind)}
        >
          <span className={`task-letter ${kind}`} aria-hidden="true">
            {letter}
          </span>
          {name}
        </button>
      ))}
    </div>
  );
}
