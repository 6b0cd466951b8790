// The page in Debian's Chromium with real programs behind it: `node run.mjs FOLDER_OF_PROGRAMS`.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

const programs = process.argv[2];
const { open_browser } = await import('../e2e/browser.mjs');
const { start_console } = await import('./console.mjs');
const shots = process.env.TACIT_SHOTS ?? join(tmpdir(), 'tacit-web-shots');
mkdirSync(shots, { recursive: true });

async function until(is_so, what, within_ms = 60_000) {
  const end = Date.now() + within_ms;
  while (!(await is_so())) {
    if (Date.now() > end) assert.fail(`never: ${what}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}

/** Keystroke-level model: a key 0.2 s, pointing 1.1 s, a button 0.1 s, homing 0.4 s, thinking 1.35 s. */
const kKey_s = 0.2;
const kClick_s = 1.1 + 0.1 + 0.1;
const kThink_s = 1.35;
const kHome_s = 0.4;

/** What a person does, counted. */
class Person {
  actions = 0;
  seconds = 0;
  async click(locator) {
    this.actions += 1;
    this.seconds += kThink_s + kClick_s;
    await locator.click();
  }
  async choose(locator, value) {
    this.actions += 2;
    this.seconds += kThink_s + 2 * kClick_s;
    await locator.selectOption(value);
  }
  async type(locator, text) {
    this.actions += 1;
    this.seconds += kThink_s + kClick_s + 2 * kHome_s + kKey_s * text.length;
    await locator.fill(text);
  }
}

async function with_page(body) {
  const console_ = await start_console(programs);
  const browser = await open_browser();
  const page = browser.context.pages()[0] ?? (await browser.context.newPage());
  const errors = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  try {
    await page.goto(console_.url);
    await body(page, console_);
    assert.deepEqual(errors, []);
  } catch (error) {
    await page.screenshot({ path: join(shots, 'real-failed.png') }).catch(() => {});
    throw error;
  } finally {
    await browser.close();
    await console_.close();
  }
}

/** A mission from an empty page to its run, as a novice would. */
async function plan(page, person, wish) {
  await person.click(page.getByRole('link', { name: 'Plan', exact: true }).or(page.getByRole('button', { name: 'Plan', exact: true })).first());
  await person.choose(page.locator('.field select').first(), 'office');
  await page.getByText('Laboratory').first().waitFor();
  await person.click(page.getByRole('button', { name: 'Biohazard' }).first());
  const form = page.getByRole('form', { name: 'Add a task by its place' });
  await person.type(form.getByLabel('x, m'), '20');
  await person.type(form.getByLabel('y, m'), '22');
  await person.click(form.getByRole('button', { name: 'Add' }));
  await person.choose(page.getByRole('combobox', { name: 'Robots' }), String(wish.robots));
  if (wish.enemy) await person.click(page.getByLabel('An enemy is expected'));
  await person.click(page.getByRole('button', { name: 'Review plans' }));
  await person.click(page.getByRole('button', { name: 'Preview', exact: true }));
  await page.getByText('10 of 10 flights flown').waitFor({ timeout: 60_000 });
  await page.screenshot({ path: join(shots, `real-review-${wish.robots}.png`) });
  await person.click(page.getByRole('button', { name: 'Run this plan' }));
  await page.getByLabel('Speed, × real time').fill('0');
  await person.click(page.getByRole('button', { name: 'Run', exact: true }));
}

for (const wish of [{ name: 'Test 1', robots: 1, enemy: false }, { name: 'Test 2', robots: 2, enemy: true }]) {
  test(`${wish.name}: a novice plans it, runs it to a full checklist, tells the wizard and stores it`, () =>
    with_page(async (page, console_) => {
      const person = new Person();
      await plan(page, person, wish);
      console.log(`# ${wish.name} with the wizard: ${person.actions} actions, ${person.seconds.toFixed(1)} s by the keystroke-level model`);
      await page.getByRole('heading', { name: 'Debrief' }).waitFor({ timeout: 90_000 });
      const [run] = await console_.ask('GET', 'api/runs');
      const result = await console_.ask('GET', `api/runs/${run.id}`);
      assert.equal(result.score.done, result.score.wanted, JSON.stringify(result.checklist, null, 2));
      await page.getByText(`${result.score.wanted} of ${result.score.wanted} sub-tasks done`).waitFor();
      await page.screenshot({ path: join(shots, `real-debrief-${wish.robots}.png`) });
      await page.getByRole('button', { name: 'Tell the wizard' }).click();
      await page.getByText('The wizard has noted it').waitFor();
      await page.getByRole('button', { name: 'Store the case' }).click();
      await page.getByText('Stored', { exact: false }).first().waitFor();
    }));
}

test('a guard run is watched, paused, stepped, sped up and stopped', () =>
  with_page(async (page, console_) => {
    const { id } = await console_.ask('POST', 'api/runs', { scenario: 'guard', robots: 6, learner: 'lm', speed: 5 });
    await page.locator('[data-robot]').first().waitFor({ timeout: 30_000 });
    await until(async () => (await page.locator('[data-robot]').count()) === 6, 'six robots');
    const tick = async () => Number(/Tick\s*([\d,. ]+?)\s*of/.exec(await page.locator('main, body').first().innerText())?.[1].replace(/\D/g, ''));
    await until(async () => (await tick()) > 10, 'ticks go by');
    await page.getByRole('button', { name: 'Pause' }).click();
    await page.getByRole('button', { name: 'Play' }).waitFor();
    let before = -1;
    await until(async () => {
      const now = await tick();
      const still = now === before;
      before = now;
      await page.waitForTimeout(400);
      return still;
    }, 'the ticks stand still');
    await page.getByRole('button', { name: 'Step' }).click();
    await until(async () => (await tick()) === before + 1, 'one step');
    await page.getByRole('button', { name: 'Play' }).click();
    await until(async () => (await tick()) > before + 20, 'it goes on');
    await page.locator('[data-robot]').first().click();
    await page.screenshot({ path: join(shots, 'real-guard.png') });
    await console_.ask('DELETE', `api/runs/${id}`);
    await until(async () => (await console_.ask('GET', 'api/runs'))[0].state === 'stopped', 'stopped');
  }));
