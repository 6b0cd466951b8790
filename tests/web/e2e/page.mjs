// One page on one pretended console, and the questions that every test asks of it.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { need } from '../mock/packages.mjs';
import { start_mock } from '../mock/server.mjs';
import { open_browser } from './browser.mjs';

const axe = readFileSync(need.resolve('axe-core/axe.min.js'), 'utf8');
export const shots = process.env.TACIT_SHOTS ?? join(tmpdir(), 'tacit-web-shots');
let failures = 0;
mkdirSync(shots, { recursive: true });

/** Runs `body` with a page; fails when the page threw or logged an error that is not expected. */
export async function with_page(options, body) {
  const mock = await start_mock(options);
  const browser = await open_browser(options.window);
  const page = browser.context.pages()[0] ?? (await browser.context.newPage());
  const errors = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error' && !expected(message, options)) errors.push(message.text());
  });
  try {
    await page.goto(mock.url + (options.at ?? '/'));
    await body(page, mock);
    assert.deepEqual(errors, []);
  } catch (error) {
    await page.screenshot({ path: join(shots, `failed-${(failures += 1)}.png`) }).catch(() => {});
    throw error;
  } finally {
    await browser.close();
    await mock.close();
  }
}

/** The browser itself logs what a server refuses. */
function expected(message, { refuses }) {
  return refuses && /Failed to load resource|WebSocket connection/.test(message.text());
}

export async function shot(page, name) {
  await page.screenshot({ path: join(shots, `${name}.png`) });
}

/** No serious finding of axe, in light and in dark. */
export async function accessible(page, name) {
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    await page.waitForTimeout(150);
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() =>
      window.axe.run(document, {
        runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'],
      }),
    );
    await shot(page, `${name}-${colorScheme}`);
    const serious = violations
      .filter(({ impact }) => impact === 'serious' || impact === 'critical')
      .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map((node) => node.html.slice(0, 160)).join(' | ')}`);
    assert.deepEqual(serious, [], `${name}, ${colorScheme}`);
    const others = violations.filter(({ impact }) => impact !== 'serious' && impact !== 'critical');
    for (const { id, nodes } of others) console.log(`# axe, ${name}: ${id} (${nodes.length})`);
  }
  await page.emulateMedia({ colorScheme: 'light' });
}

/** Until it is so, for at most a minute: other work may be going on. */
export async function until(is_so, what) {
  const end = Date.now() + 60_000;
  while (!(await is_so())) {
    if (Date.now() > end) assert.fail(`never: ${what}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}
