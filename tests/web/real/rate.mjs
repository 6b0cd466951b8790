// What a console costs a run that goes at full speed: `node rate.mjs FOLDER_OF_PROGRAMS [ROUNDS]`. Each round has a run
// without a console, one with a console that nobody looks at, and one watched by a client that takes
// every channel, so that a busy machine hurts all three alike.
import { execFile, spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { need } from '../mock/packages.mjs';

const WebSocket = need('ws');
const [programs, rounds = '7'] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'tacit-rate-'));
let runs = 0;

/** Ticks a second of six soldiers over DDS. */
function rate() {
  const out = join(folder, 'runs', `run${(runs += 1)}`);
  const words = ['run', 'guard', '--robots', '6', '--speed', 'max', '--duration', '1500', '--quiet', '--json',
    '--out', out, '--store', join(folder, 'runs.db')];
  return new Promise((done, failed) =>
    execFile(join(programs, 'tacit'), words, (error, text) => (error ? failed(error) : done(JSON.parse(text).ticks_per_s))));
}

async function rate_with_console(is_watched) {
  const console_ = spawn(join(programs, 'console'),
    ['serve', '--port', '0', '--runs', join(folder, 'runs'), '--cases', join(folder, 'cases.db')],
    { stdio: ['ignore', 'pipe', 'ignore'] });
  const url = await new Promise((done) => console_.stdout.once('data', (bytes) => done(String(bytes).trim())));
  let socket;
  let over = false;
  const watch = () => {
    socket = new WebSocket(`${url.replace('http', 'ws')}ws`, ['foxglove.sdk.v1']);
    let id = 0;
    socket.on('message', (message, binary) => {
      const said = binary ? {} : JSON.parse(message);
      if (said.op !== 'advertise') return;
      const subscriptions = said.channels.map((channel) => ({ id: (id += 1), channelId: channel.id }));
      socket.send(JSON.stringify({ op: 'subscribe', subscriptions }));
    });
    socket.on('error', () => over || setTimeout(watch, 30));
  };
  if (is_watched) watch();
  const found = await rate();
  over = true;
  socket?.terminate();
  const ended = new Promise((done) => console_.on('exit', done));
  console_.kill('SIGINT');
  await ended;
  return found;
}

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];
const table = { without: [], unwatched: [], watched: [] };
for (let i = 0; i < Number(rounds); i += 1) {
  table.without.push(await rate());
  table.unwatched.push(await rate_with_console(false));
  table.watched.push(await rate_with_console(true));
}
for (const [name, rates] of Object.entries(table)) {
  const ratio = median(rates) / median(table.without);
  console.log(`${name.padEnd(10)} ${median(rates).toFixed(0).padStart(6)} ticks/s  ${ratio.toFixed(3)}`);
}
rmSync(folder, { recursive: true, force: true });
