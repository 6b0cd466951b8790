import type { Run } from '@/api/types';
import { csv } from '@/results/csv';
import { filtered, sorted } from '@/results/table';

const run = (id: string, more: Partial<Run> = {}): Run => ({
  id, name: `guard ${id}`, scenario: 'guard', seed: 1, state: 'done', started: '2026-01-01T00:00:00Z',
  ticks: 10, robots: 2, score: null, recording: false, ...more,
});

test('every word of the filter has to fit', () => {
  const runs = [run('a'), run('b', { scenario: 'forage', name: 'forage b' }), run('c', { state: 'failed' })];
  expect(filtered(runs, { words: 'FORAGE b', state: '' }).map((one) => one.id)).toEqual(['b']);
  expect(filtered(runs, { words: '', state: 'failed' }).map((one) => one.id)).toEqual(['c']);
});

test('numbers are sorted as numbers, equal ones stay in order', () => {
  const runs = [run('a', { ticks: 9 }), run('b', { ticks: 100 }), run('c', { ticks: 9 })];
  expect(sorted(runs, { by: 'ticks', down: true }).map((one) => one.id)).toEqual(['b', 'a', 'c']);
});

test('a run without a score is last when the best are first', () => {
  const runs = [run('a'), run('b', { score: { done: 0, wanted: 9 } })];
  expect(sorted(runs, { by: 'score', down: true }).map((one) => one.id)).toEqual(['b', 'a']);
});

test('a cell with quotes, commas or a formula is only text', () => {
  expect(csv([['a,"b"', '=1+1', -2, null]])).toBe('"a,""b""",\'=1+1,-2,\r\n');
});
