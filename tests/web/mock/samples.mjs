// What the pretended console knows: maps, missions, plans, finished runs.
import { readFileSync } from 'node:fs';

const repository = new URL('../../../', import.meta.url);
const read = (path) => readFileSync(new URL(path, repository), 'utf8');

const circle = (n, r, x, y) =>
  Array.from({ length: n }, (_, i) => [
    x + 12 * Math.cos(i * 2.4) * (1 + i / 6), y + 12 * Math.sin(i * 2.4) * (1 + i / 6), r,
  ]);

export const field = {
  name: 'field', width_m: 60, height_m: 60, shift: { x: 0, y: 0 }, walls: [],
  discs: circle(9, 1.2, 30, 30), rooms: [], doors: [], halls: [], points: [],
  start: null, target: null, base: { x: 30, y: 30, r: 3 },
};

/** Enough of an overlay to draw it: the map's frame is the world's. */
function scene_of(name) {
  const text = read(`deploy/maps/${name}.ovl`);
  const lines = text.split('\n').map((line) => line.replace(/--.*$/, ''));
  const scene = {
    name, width_m: 50, height_m: 50, shift: { x: 0, y: 0 }, walls: [], discs: [], rooms: [],
    doors: [], halls: [], points: [], start: null, target: null, base: null,
  };
  for (const line of lines) {
    const [, keyword = '', called = '', rest = ''] =
      /^\s*([A-Z-]+)\s+(?:("[^"]*")\s*)?(.*)$/.exec(line) ?? [];
    const label = called.slice(1, -1).replace(/\*$/, '');
    const n = rest.split(/[\s,]+/).filter((word) => /^-?[\d.]+$/.test(word)).map(Number);
    if (keyword === 'MISSION-AREA') [scene.width_m, scene.height_m] = n;
    if (keyword === 'WALL') {
      for (let i = 0; i + 3 < n.length; i += 2) scene.walls.push(n.slice(i, i + 4));
    }
    if (keyword === 'ROOM') {
      const outline = n.reduce((all, x, i) => (i % 2 ? all : [...all, [x, n[i + 1]]]), []);
      scene.rooms.push({ name: label, outline });
    }
    if (keyword === 'DOOR') scene.doors.push({ name: label, from: [n[0], n[1]], to: [n[2], n[3]] });
    if (keyword === 'PP' && label === 'StartPlace') scene.start = { x: n[0], y: n[1] };
    else if (keyword === 'PP') scene.points.push({ name: label, x: n[0], y: n[1], r: n[2] ?? 0 });
    if (keyword === 'HALLWAY') {
      const width_m = Number(/WIDTH\s+([\d.]+)/.exec(line)?.[1] ?? 2);
      const line_of = /CENTERLINE\s+([\d.\s]+)WIDTH/.exec(line)?.[1].trim().split(/\s+/).map(Number) ?? [];
      const centre = line_of.reduce((all, x, i) => (i % 2 ? all : [...all, [x, line_of[i + 1]]]), []);
      scene.halls.push({ name: label, centre, width_m });
    }
    if (keyword === 'OBSTACLE' && n.length >= 3) scene.discs.push(n.slice(0, 3));
  }
  return scene;
}

export const office = scene_of('office');
export const scenes = {
  office, minefield: scene_of('minefield'), waypoints: scene_of('waypoints'),
};
export const maps = Object.keys(scenes).map((name) => ({ name }));
export const missions = [
  { name: 'biohazard', title: 'One robot looks for a biohazard in an office building.' },
  { name: 'eod', title: 'Mines into the area where they belong.' },
];
export const scenarios = [
  { name: 'forage', description: 'A foraging team learns its roles by Q-learning.' },
  { name: 'guard', description: 'Soldiers guard a target with Learning Momentum.' },
];

const names = ['guard lm', 'guard static1', 'forage q', 'office plan', 'minefield eod'];

export function finished_runs() {
  return Array.from({ length: 24 }, (_, i) => ({
    id: `f${24 - i}`, name: names[i % names.length], seed: 100 + i, robots: 2 + (i % 9),
    scenario: ['guard', 'guard', 'forage', 'office', 'minefield'][i % 5],
    state: ['done', 'done', 'stopped', 'failed', 'done'][(i * 7) % 5],
    started: new Date(Date.UTC(2026, 2, 1, 20, 0) - i * 5_400_000).toISOString(),
    ticks: 3000 + 911 * i,
    score: i % 5 > 2 ? { done: 5 + (i % 4), wanted: 9 } : null,
    operation: i % 5 > 2, recording: i % 2 === 0,
  }));
}

export function detail({ operation, ...run }) {
  return {
    ...run,
    metrics: [
      { name: 'enemies_intercepted', value: 0.87, unit: '', meaning: 'Share of enemies intercepted' },
      { name: 'mean_distance', value: 41.27, unit: 'm', meaning: 'Mean distance to the target at interception' },
      { name: 'run_time', value: run.ticks / 10, unit: 's', meaning: 'Simulated time' },
      { name: 'collisions', value: 3, unit: '', meaning: 'Collisions of robots' },
    ],
    checklist: operation
      ? [
          { name: 'Enter the hallway', done: true, evidence: 'Robot 1 was in it at tick 0 (0.0 s).' },
          { name: 'Enter Laboratory', done: true, evidence: 'Robot 1 entered at tick 812 (81.2 s).' },
          { name: 'Test object 2 once', done: true, evidence: 'Robot 1 tested it at tick 900 (90.0 s).' },
          { name: 'Enter Library', done: false, evidence: 'No robot of the team entered.' },
        ]
      : null,
  };
}

const kWords = {
  biohazard: 'BiohazardTask', eod: 'EODTask', waypoint: 'WaypointsTask', hostage: 'HostageMonitoringTask',
  rescue: 'SearchAndRescueTask',
};

export function plans(tasks) {
  const mission = read('deploy/missions/biohazard.cdl');
  const used = (misses) =>
    tasks.map((task, i) => ({
      id: 10 + i, task: i, title: `A ${task.task} task, seen through`,
      record: i === 0 ? '9 of 10 outcomes good; last failure: Enter Library.' : '',
      features: [
        { feature: 'Task', wanted: kWords[task.task], found: kWords[task.task], matches: true },
        { feature: 'NumberOfRobots', wanted: '2', found: misses > 0 ? '1' : '2', matches: misses === 0 },
        { feature: 'Localization', wanted: '', found: 'UseMaps', matches: true },
        { feature: 'Environment', wanted: 'Indoor', found: 'Indoor', matches: true },
        { feature: 'HandlesEnemy', wanted: 'False', found: misses > 1 ? 'True' : 'False', matches: misses < 2 },
      ],
    }));
  const changes = [
    { step: 'adapt', rule: 'goal', why: 'The case went to a place of its own map.', before: 'Goal_Location 12 30', after: `Goal_Location ${tasks[0].x} ${tasks[0].y}`, mended: true },
    { step: 'adapt', rule: 'velocity', why: 'At most 0.5 m/s is wanted.', before: 'max_vel 0.9 m/s', after: 'max_vel 0.5 m/s', mended: true },
    { step: 'criticize', rule: 'unreachable-goal', why: 'The place of task 1 is too near to a wall.', before: '5.0, 12.0', after: '5.6, 12.4', mended: true },
    { step: 'criticize', rule: 'no-exit', why: 'State Survey has no way out when nothing is found.', before: '', after: '', mended: false },
  ];
  return {
    plans: [
      { stars: 4.6, arrangement: 'Every robot does every task, in order.', mission, cases: used(0), changes },
      { stars: 3.1, arrangement: 'The first robot does the tasks; the second covers it.', mission, cases: used(1), changes: changes.slice(0, 2) },
      { stars: 2.0, arrangement: 'The tasks are shared out between the robots.', mission, cases: used(2), changes: [] },
    ],
    notes: ['No case is for more than two robots.'],
  };
}
