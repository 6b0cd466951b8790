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
  return {
    url,
    /** JSON in, JSON out. */
    ask: async (method, path, body) => {
      const answer = await fetch(url + path, {
        method,
        headers: body ? { 'content-type': 'application/json' } : {},
        body: body && JSON.stringify(body),
      });
      return answer.json();
    },
    close: async () => {
      const ended = new Promise((done) => child.on('exit', done));
      child.kill('SIGINT');
      await ended;
      rmSync(folder, { recursive: true, force: true });
    },
  };
}
