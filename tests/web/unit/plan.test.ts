import type { Scene } from '@/api/types';
import { problems_of } from '@/plan/check';
import { change, kEmpty, request_of, type Draft } from '@/plan/draft';
import { features_of } from '@/plan/features';

/** 20 m by 10 m, a wall across at x = 10 with no way through, an obstacle at 4, 4. */
const kScene: Scene = {
  name: 'halves', width_m: 20, height_m: 10, shift: { x: 100, y: 0 },
  walls: [[110, 0, 110, 10]], discs: [[104, 4, 1]],
  rooms: [{ name: 'East', outline: [[110, 0], [120, 0], [120, 10], [110, 10]] }],
  doors: [], halls: [], points: [], start: { x: 101, y: 1 }, target: null, base: null,
};
const kMapped: Draft = { ...kEmpty, map: 'halves' };
const with_task = (x: number, y: number) => change.add(kMapped, 'waypoint', x, y);
const whats = (draft: Draft) => problems_of(draft, kScene).map((problem) => problem.what);

test('an order changes and nothing else', () => {
  const two = change.add(with_task(1, 1), 'eod', 2, 2);
  const turned = change.reorder(two, 2, -1);
  expect(turned.tasks.map((task) => task.id)).toEqual([2, 1]);
  expect(change.reorder(turned, 2, -1)).toBe(turned);
});

test('a copy has a number of its own and comes right after', () => {
  const copied = change.duplicate(change.add(with_task(1, 1), 'eod', 2, 2), 1);
  expect(copied.tasks.map((task) => task.id)).toEqual([1, 3, 2]);
});

test('what is left open is not in the request', () => {
  const draft = change.set(with_task(1, 1), 1, { environment: 'Indoor' });
  const opened = change.set(draft, 1, { environment: undefined as never });
  expect(request_of(opened)).toEqual({
    tasks: [{ task: 'waypoint', x: 1, y: 1 }], enemy: false, max_velocity_mps: 0.5,
    aggressiveness: 0.3, top: 3,
  });
});

test('a place in the open in reach is right', () => {
  expect(whats(with_task(7, 7))).toEqual([]);
});

test.each([
  ['outside the map', 25, 5],
  ['inside an obstacle', 4.2, 4],
  ['very near to a wall', 9.9, 5],
  ['out of reach', 15, 5],
])('a place %s is found, and its fix mends it', (words, x, y) => {
  const draft = with_task(x, y);
  const [problem] = problems_of(draft, kScene);
  expect(problem?.what).toContain(words);
  const mended = problem!.fix!.apply(draft);
  expect(whats(mended).join()).not.toContain(words);
});

test('a contradiction between mission and task is found', () => {
  const draft = change.prefer(change.set(with_task(7, 7), 1, { handles_enemy: false }), { enemy: true });
  const [problem] = problems_of(draft, kScene);
  expect(problem?.what).toContain('does not consider the enemy');
  expect(whats(problem!.fix!.apply(draft))).toEqual([]);
});

test('a preference outside its range is an error', () => {
  const draft = change.prefer(with_task(7, 7), { max_velocity_mps: 3 });
  const [problem] = problems_of(draft, kScene);
  expect(problem?.level).toBe('error');
  expect(problem!.fix!.apply(draft).preferences.max_velocity_mps).toBe(1);
});

test('a case is stored under what was wanted, else under what the case had', () => {
  const found = (feature: string, value: string) => ({ feature, wanted: '', found: value, matches: true });
  const plan = {
    stars: 4, arrangement: '', mission: '', changes: [],
    cases: [{ id: 1, title: '', task: 0, record: '', features: [
      found('NumberOfRobots', '2'), found('Localization', 'UseLandmarks'), found('Environment', 'Outdoor'),
      found('HandlesEnemy', 'True'),
    ] }],
  };
  expect(features_of([{ task: 'eod', x: 0, y: 0, environment: 'Indoor' }], plan, null)).toEqual([
    { task: 'eod', robots: 2, localization: 'UseLandmarks', environment: 'Indoor', handles_enemy: true },
  ]);
});
