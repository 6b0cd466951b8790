import { test } from 'node:test';
import { accessible, shot, until, with_page } from './page.mjs';

test('a console without runs says how to begin', () =>
  with_page({ empty: true, refuses: true }, async (page) => {
    await page.getByText('No run is live').waitFor();
    await accessible(page, 'empty-operate');
    await page.getByRole('link', { name: 'Results', exact: true }).click();
    await page.getByText('There are no results yet').waitFor();
    await shot(page, 'empty-results');
  }));

test('a console that fails is told, and asked again', () =>
  with_page({ failing: true, refuses: true, at: '/#/results' }, async (page, mock) => {
    await page.getByText('the run store cannot be read').waitFor();
    await accessible(page, 'failing');
    mock.state.failing = false;
    await page.getByRole('button', { name: 'Try again' }).click();
    await until(async () => (await page.locator('.results-table tbody tr').count()) === 25, 'runs');
  }));

test('the page is usable in a narrow window, as at 200 % zoom', () =>
  with_page({ window: { width: 700, height: 800 } }, async (page) => {
    await page.locator('[data-robot]').first().waitFor();
    await accessible(page, 'narrow');
    const wider = await page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth + 1);
    if (wider) throw new Error('the page has to be scrolled sideways');
  }));
