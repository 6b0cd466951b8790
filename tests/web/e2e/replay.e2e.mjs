import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible, shot, until, with_page } from './page.mjs';

const recording = (mock) => mock.worlds.get('replay-f24');
const slider = (page) => page.getByRole('slider', { name: 'Time' });
const at = async (page) => Number(await slider(page).inputValue());
const calls = (mock, service) => (recording(mock)?.calls ?? []).filter(([name]) => name === service);

test('a recorded run is played from its results, and closed when it is left', () =>
  with_page({ at: '/#/results/f24' }, async (page, mock) => {
    await page.getByRole('link', { name: 'Replay' }).click();
    await page.locator('[data-robot]').first().waitFor();
    await page.locator('.phase.paused').waitFor();
    assert.equal(await page.getByRole('button', { name: 'Stop' }).count(), 0);
    await page.keyboard.press('n');
    await page.getByText('Gains over time').waitFor();
    assert.equal(await page.getByText('Operator').count(), 0);
    await page.getByLabel('Speed').selectOption('16');
    await page.keyboard.press('Escape');
    await page.locator('h1').click();
    await page.keyboard.press(' ');
    await page.locator('.phase.running').waitFor();
    await until(async () => (await at(page)) > 40, 'played on');
    await page.keyboard.press('n');
    await page.keyboard.press(' ');
    await page.locator('.phase.paused').waitFor();
    await until(async () => (await page.locator('.event').count()) > 2, 'events');
    assert.equal(await page.getByText('enemies alive').count(), 0);
    await accessible(page, 'replay');
    await page.getByRole('link', { name: 'Results', exact: true }).first().click();
    await until(() => mock.state.replays_closed.includes('f24'), 'closed');
  }));

test('a replay is moved by keys, by its events and by its address', () =>
  with_page({ at: '/#/replay/f24?t=30' }, async (page, mock) => {
    await page.locator('[data-robot]').first().waitFor();
    await until(async () => Math.abs((await at(page)) - 30) < 0.01, 'the moment of the address');
    await slider(page).focus();
    for (const [key, time_s] of [
      ['ArrowRight', 31], ['ArrowLeft', 30], ['PageUp', 40], ['PageDown', 30], ['End', 120], ['Home', 0],
    ]) {
      await page.keyboard.press(key);
      await until(async () => Math.abs((await at(page)) - time_s) < 0.01, key);
      await until(() => Math.abs(recording(mock).time_s - time_s) < 0.01, `${key} told`);
    }
    await page.keyboard.press('.');
    await until(() => calls(mock, 'step').length === 1, 'a step');
    for (let i = 0; i < 5; ++i) await page.keyboard.press('+');
    await until(() => recording(mock).speed === 64, 'faster');
    await page.keyboard.press(' ');
    await until(() => recording(mock).time_s >= 120, 'played to its end');
    await page.getByText('at its end').waitFor();
    await page.keyboard.press('j');
    await until(async () => (await at(page)) < 119.9, 'the event before');
    const here = await at(page);
    await page.keyboard.press('j');
    await until(async () => (await at(page)) < here - 0.05, 'the one before that');
    await page.keyboard.press('k');
    await until(async () => Math.abs((await at(page)) - here) < 0.01, 'and after');
    await until(() => page.url().includes(`t=${Number(here.toFixed(1))}`), 'the address');
    await page.locator('.event .at').first().click();
    await until(async () => (await at(page)) < here - 1, 'to an event of the list');
    await page.evaluate(() => (location.hash = '#/replay/f24?t=77'));
    await until(async () => Math.abs((await at(page)) - 77) < 0.01, 'an address that was changed');
    await shot(page, 'replay-keys');
  }));

test('a replay that is gone is opened again where it was', () =>
  with_page({ at: '/#/replay/f24?t=50', refuses: true }, async (page, mock) => {
    await page.locator('.facts').getByText('500', { exact: true }).waitFor();
    mock.worlds.delete('replay-f24');
    mock.drop_sockets();
    await page.getByRole('button', { name: 'Try now' }).click();
    await until(() => calls(mock, 'seek').length === 1, 'opened again');
    assert.deepEqual(calls(mock, 'seek')[0][1], { time_s: 50 });
    await page.locator('.facts').getByText('500', { exact: true }).waitFor();
  }));

test('a run without a recording says how to get one', () =>
  with_page({ at: '/#/replay/f23' }, async (page) => {
    await page.getByText('has no recording').waitFor();
    await accessible(page, 'replay-none');
    await page.goto(page.url().replace('replay', 'results'));
    await page.getByText('tacit run --record').waitFor();
  }));

test('a replay fits a narrow window', () =>
  with_page({ at: '/#/replay/f24', window: { width: 700, height: 800 } }, async (page) => {
    await page.locator('[data-robot]').first().waitFor();
    await accessible(page, 'replay-narrow');
    const wider = await page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth + 1);
    assert.ok(!wider, 'the page has to be scrolled sideways');
  }));
