import type { Run } from '@/api/types';

export type Column = 'name' | 'scenario' | 'state' | 'started' | 'robots' | 'seed' | 'ticks' | 'score';

export interface Sorting {
  by: Column;
  down: boolean;
}

export interface Filter {
  words: string;
  state: Run['state'] | '';
}

const kValues: Record<Column, (run: Run) => string | number> = {
  name: (run) => run.name || run.id,
  scenario: (run) => run.scenario,
  state: (run) => run.state,
  started: (run) => Date.parse(run.started) || 0,
  robots: (run) => run.robots,
  seed: (run) => run.seed,
  ticks: (run) => run.ticks,
  score: (run) => (run.score && run.score.wanted > 0 ? run.score.done / run.score.wanted : -1),
};

/** Every word has to be in a run's name, scenario or id. */
export function filtered(runs: readonly Run[], { words, state }: Filter): Run[] {
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
  return runs.filter((run) => {
    const text = `${run.id} ${run.name} ${run.scenario} seed ${run.seed}`.toLowerCase();
    return (state === '' || run.state === state) && wanted.every((word) => text.includes(word));
  });
}

/** Runs of the same value stay in their order. */
export function sorted(runs: readonly Run[], { by, down }: Sorting): Run[] {
  const value = kValues[by];
  const sign = down ? -1 : 1;
  return [...runs].sort((a, b) => {
    const [x, y] = [value(a), value(b)];
    if (typeof x === 'string') return sign * x.localeCompare(String(y), undefined, { numeric: true });
    return sign * (x - Number(y));
  });
}
