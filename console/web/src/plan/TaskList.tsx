import { useEffect, useRef, useState } from 'react';

import type { Environment, Localization, TaskKind } from '@/api/types';
import type { Problem } from '@/plan/check';
import { change, kTasks, name_of, type DraftTask } from '@/plan/draft';
import { useDraft } from '@/plan/store';

interface Props {
  problems: Problem[];
  selected: number | null;
  select: (task: number | null) => void;
  tool: TaskKind | null;
}

export function TaskList({ problems, selected, select, tool }: Props) {
  const { tasks, map } = useDraft();
  return (
    <section aria-label="Tasks">
      <h2>Tasks, in order</h2>
      {tasks.length === 0 ? (
        <p className="hint">None yet. Choose a task above the map and click where it is to be done.</p>
      ) : (
        <ol className="tasks">
          {tasks.map((task, i) => (
            <Item
              key={task.id} task={task} number={i + 1} last={i + 1 === tasks.length}
              chosen={task.id === selected} select={select}
              bad={problems.some((problem) => problem.task === task.id)}
            />
          ))}
        </ol>
      )}
      <AddAt disabled={!map} tool={tool ?? 'waypoint'} select={select} />
    </section>
  );
}

function Item(props: {
  task: DraftTask; number: number; last: boolean; chosen: boolean; bad: boolean;
  select: (task: number | null) => void;
}) {
  const { task, number, chosen } = props;
  const set = useDraft((state) => state.change);
  const item = useRef<HTMLLIElement>(null);
  useEffect(() => {
    if (chosen) item.current?.scrollIntoView({ block: 'nearest' });
  }, [chosen]);
  const title = `task ${number}, ${name_of(task.task)}`;
  return (
    <li ref={item} className={chosen ? 'chosen' : ''}>
      <div className="task-row">
        <button
          type="button" className="task-name" aria-expanded={chosen}
          onClick={() => props.select(chosen ? null : task.id)}
        >
          <span className="task-number">{number}</span>
          {name_of(task.task)}
          <span className="hint">
            {task.x}, {task.y} m
          </span>
          {props.bad && <span className="task-bad">⚠<span className="unseen"> has a problem</span></span>}
        </button>
        <button type="button" className="quiet" aria-label={`Earlier: ${title}`} disabled={number === 1}
          onClick={() => set((now) => change.reorder(now, task.id, -1))}>
          ↑
        </button>
        <button type="button" className="quiet" aria-label={`Later: ${title}`} disabled={props.last}
          onClick={() => set((now) => change.reorder(now, task.id, 1))}>
          ↓
        </button>
        <button type="button" className="quiet" aria-label={`Duplicate ${title}`}
          onClick={() => set((now) => change.duplicate(now, task.id))}>
          ❐
        </button>
        <button type="button" className="quiet" aria-label={`Delete ${title}`}
          onClick={() => {
            set((now) => change.remove(now, task.id));
            props.select(null);
          }}>
          ✕
        </button>
      </div>
      {chosen && <Constraints task={task} />}
    </li>
  );
}

/** What is wanted of one task alone. */
function Constraints({ task }: { task: DraftTask }) {
  const change_draft = useDraft((state) => state.change);
  const set = (fields: Parameters<typeof change.set>[2], burst?: string) =>
    change_draft((now) => change.set(now, task.id, fields), burst);
  const open = { value: '', label: 'left open' };
  return (
    <div className="fields constraints">
      <Choice label="Task" value={task.task} choose={(value) => set({ task: value as TaskKind })}
        choices={kTasks.map(({ kind, name }) => ({ value: kind, label: name }))} />
      <Metres label="x, m" value={task.x} set={(x) => set({ x }, `x ${task.id}`)} />
      <Metres label="y, m" value={task.y} set={(y) => set({ y }, `y ${task.id}`)} />
      <Choice label="Localization" value={task.localization ?? ''}
        choose={(value) => set({ localization: (value || undefined) as Localization })}
        choices={[open, { value: 'UseLandmarks', label: 'by landmarks' }, { value: 'UseMaps', label: 'by maps' }]} />
      <Choice label="Environment" value={task.environment ?? ''}
        choose={(value) => set({ environment: (value || undefined) as Environment })}
        choices={[open, { value: 'Indoor', label: 'indoor' }, { value: 'Outdoor', label: 'outdoor' }]} />
      <Choice label="Enemy" value={task.handles_enemy === undefined ? '' : String(task.handles_enemy)}
        choose={(value) => set({ handles_enemy: (value === '' ? undefined : value === 'true') as boolean })}
        choices={[open, { value: 'true', label: 'considered' }, { value: 'false', label: 'not considered' }]} />
    </div>
  );
}

function Choice(props: {
  label: string; value: string; choices: { value: string; label: string }[]; choose: (value: string) => void;
}) {
  return (
    <label>
      {props.label}
      <select value={props.value} onChange={(event) => props.choose(event.target.value)}>
        {props.choices.map(({ value, label }) => (
          <option key={value} value={value}>
            {label}
          </option>
        ))}
      </select>
    </label>
  );
}

function Metres(props: { label: string; value: number; set: (value: number) => void }) {
  return (
    <label>
      {props.label}
      <input
        type="number" step="0.1" value={props.value}
        onChange={(event) => {
          const value = event.target.valueAsNumber;
          if (Number.isFinite(value)) props.set(value);
        }}
      />
    </label>
  );
}

/** The way without a mouse. */
function AddAt({ disabled, tool, select }: { disabled: boolean; tool: TaskKind; select: (task: number) => void }) {
  const { change: set, tasks } = useDraft();
  const [place, set_place] = useState({ x: '', y: '' });
  const add = (event: React.FormEvent) => {
    event.preventDefault();
    set((now) => change.add(now, tool, Number(place.x), Number(place.y)));
    select(1 + Math.max(0, ...tasks.map((task) => task.id)));
    set_place({ x: '', y: '' });
  };
  return (
    <form className="add-at" onSubmit={add} aria-label="Add a task by its place">
      <span>Add {name_of(tool).toLowerCase()} at</span>
      {(['x', 'y'] as const).map((axis) => (
        <label key={axis}>
          {axis}, m
          <input
            type="number" step="0.1" required value={place[axis]} disabled={disabled}
            onChange={(event) => set_place({ ...place, [axis]: event.target.value })}
          />
        </label>
      ))}
      <button type="submit" disabled={disabled}>
        Add
      </button>
    </form>
  );
}
