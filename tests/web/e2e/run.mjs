// npm run e2e: the built page in Debian's Chromium, against a pretended console.
import { existsSync } from 'node:fs';

if (!existsSync(new URL('../../../console/web/dist/index.html', import.meta.url))) {
  console.error('e2e: the page is not built; run "npm run build" first');
  process.exit(2);
}
await import('./operate.e2e.mjs');
await import('./plan.e2e.mjs');
await import('./results.e2e.mjs');
await import('./replay.e2e.mjs');
await import('./states.e2e.mjs');
await import('./load.e2e.mjs');
