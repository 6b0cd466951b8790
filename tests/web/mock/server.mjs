// Speaks the console's REST interface and its socket, with pretended runs. For tests only.
import { createServer } from 'node:http';
import { existsSync, readFileSync } from 'node:fs';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { attach_sockets } from './foxglove.mjs';
import { Recording } from './recording.mjs';
import { World } from './world.mjs';
import * as samples from './samples.mjs';

const dist = fileURLToPath(new URL('../../../console/web/dist/', import.meta.url));
const kKinds = {
  '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css',
  '.svg': 'image/svg+xml', '.map': 'application/json',
};
// As strict as the console itself is.
const kPolicy = "default-src 'self'; style-src 'self' 'unsafe-inline'; connect-src 'self' ws:";

class Refusal extends Error {
  constructor(status, error, wanted) {
    super(error);
    Object.assign(this, { status, body: wanted ? { error, wanted } : { error } });
  }
}

export async function start_mock({ port = 0, robots = 6, empty = false, failing = false } = {}) {
  const state = {
    runs: [], worlds: new Map(), replays_closed: [], previews: new Map(), outcomes: [], cases: [], plans_asked: [],
    started: [], empty, failing, refuse_sockets: false,
  };
  if (!empty) {
    add_live(state, 'r7', { robots });
    state.runs.push(...samples.finished_runs());
  }
  const http = createServer((request, response) => answer(state, request, response));
  const sockets = attach_sockets(http, (run) =>
    state.refuse_sockets ? null : state.worlds.get(run ?? state.runs[0]?.id));
  await new Promise((done) => http.listen(port, '127.0.0.1', done));
  return {
    ...state,
    state,
    url: `http://127.0.0.1:${http.address().port}`,
    drop_sockets: sockets.drop_all,
    close: () => {
      for (const world of state.worlds.values()) world.end();
      http.closeAllConnections();
      return new Promise((done) => http.close(done));
    },
  };
}

function add_live(state, id, { robots = 6, scenario = 'forage', name = '', operation = false }) {
  const scene = operation ? samples.office : samples.field;
  const world = new World({
    id, robots, roles: !operation, size_m: operation ? 20 : 60,
    centre: operation ? [scene.width_m / 2, scene.height_m / 2] : [30, 30],
  });
  state.worlds.set(id, world);
  state.runs.unshift({
    id, name: name || `${scenario}-${id}`, scenario, seed: 7, state: 'live',
    started: '2026-03-02T09:30:00Z', get ticks() { return world.tick; }, robots, score: null,
    operation, recording: true,
  });
}

async function answer(state, request, response) {
  const url = new URL(request.url, 'http://x');
  try {
    if (!url.pathname.startsWith('/api/')) return file(url.pathname, response);
    if (state.failing) throw new Refusal(500, 'the run store cannot be read');
    const text = await body_of(request);
    const [status, body] = route(state, request.method, url.pathname, text ? JSON.parse(text) : {});
    send(response, status, body);
  } catch (error) {
    if (!(error instanceof Refusal)) console.error(error);
    send(response, error.status ?? 500, error.body ?? { error: String(error) });
  }
}

const route_table = [
  ['GET', /^\/api\/version$/, () => [200, { version: '0.1.0' }]],
  ['GET', /^\/api\/health$/, () => [200, { state: 'ok', wizard: true, live: 1 }]],
  ['GET', /^\/api\/runs$/, (s) => [200, refresh(s)]],
  ['POST', /^\/api\/runs$/, (s, _, body) => start_run(s, body)],
  ['GET', /^\/api\/runs\/([^/]+)$/, (s, [id]) => [200, samples.detail(run_called(s, id))]],
  ['DELETE', /^\/api\/runs\/([^/]+)$/, (s, [id]) => stop_run(s, id)],
  ['GET', /^\/api\/runs\/([^/]+)\/scene$/, (s, [id]) => [200, run_called(s, id).operation ? samples.office : samples.field]],
  ['POST', /^\/api\/replays$/, (s, _, { run }) => open_replay(s, run)],
  ['DELETE', /^\/api\/replays\/([^/]+)$/, (s, [run]) => close_replay(s, run)],
  ['GET', /^\/api\/maps$/, (s) => [200, s.empty ? [] : samples.maps]],
  ['GET', /^\/api\/maps\/([^/]+)$/, (_, [name]) => scene_called(name)],
  ['GET', /^\/api\/missions$/, (s) => [200, s.empty ? [] : samples.missions]],
  ['GET', /^\/api\/scenarios$/, (s) => [200, s.empty ? [] : samples.scenarios]],
  ['POST', /^\/api\/plans$/, (s, _, body) => plan(s, body)],
  ['POST', /^\/api\/previews$/, (s, _, body) => start_preview(s, body)],
  ['GET', /^\/api\/previews\/([^/]+)$/, (s, [id]) => [200, preview_state(s, id)]],
  ['DELETE', /^\/api\/previews\/([^/]+)$/, (s, [id]) => {
    s.previews.get(id).state = 'cancelled';
    return [200, {}];
  }],
  ['POST', /^\/api\/outcomes$/, (s, _, body) => {
    s.outcomes.push(body);
    return [200, { text: 'Noted for 1 case.' }];
  }],
  ['POST', /^\/api\/cases$/, (s, _, body) => {
    s.cases.push(body);
    return [200, { text: 'Stored 1 new case.' }];
  }],
];

function route(state, method, path, body) {
  for (const [wanted, pattern, then] of route_table) {
    const match = wanted === method && pattern.exec(path);
    if (match) return then(state, match.slice(1).map(decodeURIComponent), body);
  }
  throw new Refusal(404, `nothing is at ${path}`);
}

function refresh(state) {
  for (const run of state.runs) {
    const world = state.worlds.get(run.id);
    if (world && world.phase === 'stopped') Object.assign(run, { state: 'stopped' });
    if (world && world.phase === 'ended') Object.assign(run, { state: 'done', score: { done: 8, wanted: 9 } });
  }
  return state.runs.map(({ operation, ...run }) => run);
}

function run_called(state, id) {
  refresh(state);
  const run = state.runs.find((one) => one.id === id);
  if (!run) throw new Refusal(404, `there is no run "${id}"`);
  return run;
}

function start_run(state, body) {
  if (!body.scenario && !body.mission && !body.mission_name) {
    throw new Refusal(422, 'nothing to run', 'a scenario or a mission');
  }
  state.started.push(body);
  const id = `r${state.runs.length + 7}`;
  const operation = !body.scenario;
  add_live(state, id, { robots: body.robots ?? 2, scenario: body.scenario ?? 'operation',
    name: body.scenario ?? 'plan on office', operation });
  return [201, { id }];
}

function stop_run(state, id) {
  run_called(state, id);
  const world = state.worlds.get(id);
  if (world) world.phase = 'stopped';
  return [200, {}];
}

const kRecorded_ticks = 1200;

function open_replay(state, run) {
  const { robots, operation, recording } = run_called(state, run);
  if (!recording) throw new Refusal(422, `the run ${run} has no recording, wanted one made with --record`);
  const id = `replay-${run}`;
  const centre = operation ? [samples.office.width_m / 2, samples.office.height_m / 2] : [30, 30];
  const world = new World({ id, robots, roles: !operation, size_m: operation ? 20 : 60, centre });
  state.worlds.get(id)?.end();
  state.worlds.set(id, new Recording(id, world, kRecorded_ticks));
  return [201, { id }];
}

function close_replay(state, run) {
  state.worlds.get(`replay-${run}`)?.end();
  state.worlds.delete(`replay-${run}`);
  state.replays_closed.push(run);
  return [200, { text: 'Closed.' }];
}

function scene_called(name) {
  const scene = samples.scenes[name];
  if (!scene) throw new Refusal(404, `there is no map "${name}"`);
  return [200, scene];
}

function plan(state, body) {
  state.plans_asked.push(body);
  const { tasks } = body.request;
  if (tasks.some((task) => task.x > 1000)) {
    throw new Refusal(422, 'task 1: the place 1200, 3 is outside the map');
  }
  return [200, samples.plans(tasks)];
}

function start_preview(state, body) {
  const id = `p${state.previews.size + 1}`;
  state.previews.set(id, { state: 'running', flown: 0, flights: body.flights, asked: 0 });
  return [202, { id }];
}

function preview_state(state, id) {
  const preview = state.previews.get(id);
  if (!preview) throw new Refusal(404, `there is no preview "${id}"`);
  if (preview.state === 'running') {
    preview.flown = Math.min(preview.flights, preview.flown + 3);
    if (preview.flown === preview.flights) preview.state = 'done';
  }
  const done = preview.state === 'done';
  return {
    state: preview.state, flown: preview.flown, flights: preview.flights,
    success: preview.flown ? { share: 0.8, low: 0.49, high: 0.94 } : null,
    mean_score: preview.flown ? 0.93 : null, median_time_s: preview.flown ? 212 : null,
    failures: done ? ['Enter Library: no robot of the team entered (2 of 10).'] : [],
  };
}

function body_of(request) {
  return new Promise((done, failed) => {
    let text = '';
    request.on('data', (part) => (text += part));
    request.on('end', () => done(text));
    request.on('error', failed);
  });
}

function send(response, status, body) {
  response.writeHead(status, { 'content-type': 'application/json', 'cache-control': 'no-store' });
  response.end(JSON.stringify(body));
}

function file(path, response) {
  const wanted = join(dist, normalize(path === '/' ? '/index.html' : path));
  if (!wanted.startsWith(dist) || !existsSync(wanted)) {
    response.writeHead(404, { 'content-type': 'text/plain' });
    return response.end('not found');
  }
  response.writeHead(200, {
    'content-type': kKinds[extname(wanted)] ?? 'application/octet-stream',
    'content-security-policy': kPolicy,
  });
  response.end(readFileSync(wanted));
}
