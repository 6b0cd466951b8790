import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { accessible, until, with_page } from './page.mjs';

const rows = (page) => page.locator('.results-table tbody tr');

test('runs are filtered, sorted and exported', () =>
  with_page({ at: '/#/results' }, async (page) => {
    await until(async () => (await rows(page).count()) === 25, 'all runs');
    await accessible(page, 'results');
    await page.getByLabel('Filter runs').fill('guard static1');
    await until(async () => (await rows(page).count()) === 5, 'five runs');
    await page.getByRole('button', { name: 'Ticks' }).click();
    const ticks = await page.locator('.results-table tbody td:nth-child(7)').allInnerTexts();
    assert.deepEqual(ticks.map(Number), ticks.map(Number).sort((a, b) => b - a));
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Export CSV' }).click(),
    ]);
    const lines = readFileSync(await download.path(), 'utf8').trim().split('\r\n');
    assert.equal(lines.length, 6);
    assert.match(lines[0], /^id,name,scenario/);
    await page.getByLabel('Filter runs').fill('nothing like it');
    await page.getByText('No run fits the filter').waitFor();
  }));

test('a run is shown with metrics and checklist', () =>
  with_page({ at: '/#/results/f21' }, async (page) => {
    await page.getByText('Mean distance to the target').waitFor();
    await page.getByText('3 of 4 sub-tasks done').waitFor();
    await accessible(page, 'run');
  }));
