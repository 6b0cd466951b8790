import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible, shot, until, with_page } from './page.mjs';

const last_call = (mock) => mock.worlds.get('r7').calls.at(-1);
const called = (mock, service) => until(() => last_call(mock)?.[0] === service, service);

test('the newest live run is shown with its robots, and is accessible', () =>
  with_page({}, async (page) => {
    await page.locator('[data-robot]').nth(5).waitFor();
    assert.equal(await page.locator('[data-robot]').count(), 6);
    await page.locator('[data-robot="2"]').click();
    await page.getByText('Gains over time').waitFor();
    await page.waitForTimeout(3000);
    await accessible(page, 'operate');
  }));

test('everything of the live view goes by the keyboard', () =>
  with_page({}, async (page, mock) => {
    await page.locator('[data-robot]').first().waitFor();
    await page.locator('.phase.running').waitFor();
    await page.keyboard.press(' ');
    await called(mock, 'pause');
    await page.locator('.phase.paused').waitFor();
    await page.keyboard.press('.');
    await called(mock, 'step');
    assert.deepEqual(last_call(mock)[1], { ticks: 1 });
    await page.keyboard.press('+');
    await called(mock, 'speed');
    assert.deepEqual(last_call(mock)[1], { factor: 2 });
    await page.keyboard.press('-');
    await until(() => last_call(mock)[1].factor === 1, 'slower');
    await page.keyboard.press('n');
    await page.keyboard.press('n');
    await page.locator('[data-robot="2"][aria-selected="true"]').waitFor();
    await page.keyboard.press('p');
    await page.locator('[data-robot="1"][aria-selected="true"]').waitFor();
    for (const [key, name] of [['t', 'Trails'], ['v', 'Pushes'], ['s', 'Sensor range'], ['l', 'Follow']]) {
      const button = page.getByRole('button', { name, exact: false }).first();
      const before = await button.getAttribute('aria-pressed');
      await page.keyboard.press(key);
      await until(async () => (await button.getAttribute('aria-pressed')) !== before, name);
    }
    await page.keyboard.press('?');
    await page.getByRole('dialog', { name: 'Help' }).waitFor();
    await shot(page, 'help');
    await page.keyboard.press('Escape');
    await page.keyboard.press(' ');
    await called(mock, 'resume');
  }));

test('Tab comes to the robots, arrows go from one to the next', () =>
  with_page({}, async (page) => {
    await page.locator('[data-robot]').first().waitFor();
    for (let i = 0; i < 80; ++i) {
      await page.keyboard.press('Tab');
      if (await page.evaluate(() => document.activeElement?.hasAttribute('data-robot'))) break;
    }
    await page.keyboard.press('Enter');
    await page.locator('[data-robot="1"][aria-selected="true"]').waitFor();
    await page.keyboard.press('ArrowRight');
    await page.locator('[data-robot="2"][aria-selected="true"]').waitFor();
    await until(() => page.evaluate(() => document.activeElement?.getAttribute('data-robot') === '2'), 'focus');
  }));

test('single keys do nothing when they are turned off', () =>
  with_page({}, async (page, mock) => {
    await page.locator('.phase.running').waitFor();
    await page.getByRole('button', { name: 'Help' }).click();
    await page.getByLabel('Single keys are shortcuts').uncheck();
    await page.getByRole('button', { name: 'Close' }).click();
    await page.keyboard.press(' ');
    await page.waitForTimeout(300);
    assert.equal(last_call(mock), undefined);
  }));

test('a lost connection is told, and comes back by itself', () =>
  with_page({ refuses: true }, async (page, mock) => {
    await page.locator('.phase.running').waitFor();
    mock.state.refuse_sockets = true;
    mock.drop_sockets();
    await page.getByText('The connection was lost').waitFor();
    await page.locator('.map.stale').waitFor();
    await shot(page, 'lost');
    mock.state.refuse_sockets = false;
    await page.getByText('The connection was lost').waitFor({ state: 'detached' });
    await until(async () => (await page.locator('.map.stale').count()) === 0, 'fresh again');
  }));

test('the event log is filtered, and an event selects its robot', () =>
  with_page({}, async (page, mock) => {
    await page.locator('.event').first().waitFor();
    mock.worlds.get('r7').speed = 32;
    await until(() => mock.worlds.get('r7').log.some((event) => event.robot > 0), 'an event of a robot');
    mock.worlds.get('r7').phase = 'paused';
    await page.locator('.phase.paused').waitFor();
    await page.locator('.event button').first().click();
    await page.locator('[data-robot][aria-selected="true"]').waitFor();
    await page.getByLabel('Filter events').fill('mission begins');
    await until(async () => (await page.locator('.event').count()) === 1, 'one event');
  }));

test('stopping needs two presses', () =>
  with_page({}, async (page, mock) => {
    await page.locator('.phase.running').waitFor();
    await page.getByRole('button', { name: 'Stop' }).click();
    await page.waitForTimeout(200);
    assert.equal(last_call(mock), undefined);
    await page.getByRole('button', { name: 'Press again to stop' }).click();
    await called(mock, 'stop');
    await page.getByText('The run has been stopped').or(page.getByText('is over')).first().waitFor();
  }));

test('a run is started from a dialog', () =>
  with_page({}, async (page, mock) => {
    await page.getByRole('button', { name: 'Start a run' }).click();
    await page.getByLabel('Scenario or mission').selectOption('scenario:guard');
    await page.getByLabel('Seed').fill('42');
    await accessible(page, 'start');
    await page.getByRole('button', { name: 'Start', exact: true }).click();
    await until(() => mock.started.length === 1, 'started');
    assert.deepEqual(mock.started[0], { scenario: 'guard', seed: 42, speed: 1 });
    await page.locator('[data-robot]').first().waitFor();
  }));
