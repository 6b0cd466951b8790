// A console with real programs behind it, in a folder of its own.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export async function start_console(programs) {
  const folder = mkdtempSync(join(tmpdir(), 'tacit-real-'));
  const child = spawn(
    join(programs, 'console'),
    ['serve', '--port', '0', '--runs', join(folder, 'runs'), '--cases', join(folder, 'cases.db')],
    { stdio: ['ignore', 'pipe', 'inherit'] },
  );
  const url = await new Promise((found, failed) => {
    let text = '';
    child.stdout.on('data', (bytes) => {
      text += bytes;
      const line = /(http:\S+)\n/.exec(text);
      if (line) found(line[1]);
    });
    child.on('exit', (code) => failed(new Error(`the console ended with ${code}`)));
  });
  /** JSON in, JSON out. */
  const ask = async (method, path, body) => {
    const answer = await fetch(url + path, {
      method,
      headers: body ? { 'content-type': 'application/json' } : {},
      body: body && JSON.stringify(body),
    });
    return answer.json();
  };
  /** Runs live on without their console, also those of a test that failed. */
  const end_runs = async () => {
    for (let i = 0; i < 100; i += 1) {
      const live = (await ask('GET', 'api/runs')).filter((run) => run.state === 'live');
      if (live.length === 0) return;
      for (const run of live) await ask('DELETE', `api/runs/${run.id}`);
      await new Promise((done) => setTimeout(done, 100));
    }
  };
  return {
    url,
    ask,
    close: async () => {
      await end_runs();
      const ended = new Promise((done) => child.on('exit', done));
      child.kill('SIGINT');
      await ended;
      rmSync(folder, { recursive: true, force: true });
    },
  };
}
