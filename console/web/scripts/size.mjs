// Fails when what the browser loads at the start is above 300 kB, gzipped.
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const kMostBytes = 300_000;
const dist = fileURLToPath(new URL('../dist/', import.meta.url));
const packed = (file) => gzipSync(readFileSync(dist + file), { level: 9 }).length;
const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1)} kB`;

const page = readFileSync(`${dist}index.html`, 'utf8');
const first = new Set([...page.matchAll(/(?:src|href)="\/(assets\/[^"]+)"/g)].map((m) => m[1]));
// What the first scripts import at once comes with them.
for (const file of first) {
  if (!file.endsWith('.js')) continue;
  const text = readFileSync(dist + file, 'utf8');
  for (const m of text.matchAll(/(?:from|import)\s*"\.\/([^"]+\.js)"/g)) first.add(`assets/${m[1]}`);
}

let total = packed('index.html');
for (const file of readdirSync(`${dist}assets`).sort()) {
  const at_start = first.has(`assets/${file}`);
  const bytes = packed(`assets/${file}`);
  if (at_start) total += bytes;
  console.log(`${at_start ? 'start' : 'later'}  ${kilobytes(bytes).padStart(9)}  ${file}`);
}
console.log(`start  ${kilobytes(total).padStart(9)}  in all, at most ${kilobytes(kMostBytes)}`);
if (total > kMostBytes) process.exitCode = 1;
