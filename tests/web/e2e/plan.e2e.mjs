import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible, until, with_page } from './page.mjs';

const pins = (page) => page.locator('[data-task]');

async function choose_office(page) {
  await page.locator('.field select').selectOption('office');
  await page.locator('.task-map .map canvas').waitFor();
  await page.getByText('Laboratory').first().waitFor();
}

async function add_at(page, kind, x, y) {
  await page.getByRole('button', { name: kind }).first().click();
  const form = page.getByRole('form', { name: 'Add a task by its place' });
  await form.getByLabel('x, m').fill(String(x));
  await form.getByLabel('y, m').fill(String(y));
  await form.getByRole('button', { name: 'Add' }).click();
}

test('tasks come by click and by form, move by arrows and by dragging, and are undone', () =>
  with_page({ at: '/#/plan' }, async (page) => {
    await accessible(page, 'plan-empty');
    await choose_office(page);
    await add_at(page, 'Biohazard', 8, 16);
    assert.equal(await pins(page).count(), 1);
    await page.locator('.task-map .map').click({ position: { x: 300, y: 250 } });
    await until(async () => (await pins(page).count()) === 2, 'a task by click');

    await pins(page).first().focus();
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+ArrowUp');
    await page.getByLabel('Task 1, Biohazard, at 9, 26 metres', { exact: false }).waitFor();
    await page.keyboard.press('Control+z');
    await page.getByLabel('Task 1, Biohazard, at 8, 16 metres', { exact: false }).waitFor();
    await page.keyboard.press('Control+Shift+Z');
    await page.getByLabel('Task 1, Biohazard, at 9, 26 metres', { exact: false }).waitFor();

    const box = await pins(page).first().boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 60, y + 10, { steps: 4 });
    await page.mouse.up();
    await until(
      async () => !(await pins(page).first().getAttribute('aria-label')).includes('at 9, 26'),
      'the task was dragged',
    );
    await page.keyboard.press('Control+z');
    await page.getByLabel('Task 1, Biohazard, at 9, 26 metres', { exact: false }).waitFor();

    await page.getByRole('button', { name: 'Later: task 1' }).click();
    const second = page.locator('.task-name').nth(1);
    await until(async () => (await second.innerText()).includes('9, 26'), 'reordered');
    await page.getByRole('button', { name: 'Duplicate task 1' }).click();
    await until(async () => (await pins(page).count()) === 3, 'duplicated');
    await page.keyboard.press('Control+z');
    await until(async () => (await pins(page).count()) === 2, 'not duplicated');
    await accessible(page, 'plan-describe');

    await page.waitForTimeout(500);
    await page.reload();
    await until(async () => (await pins(page).count()) === 2, 'kept over a reload');
  }));

test('a mistake is told with why, and mended by its button', () =>
  with_page({ at: '/#/plan' }, async (page) => {
    await choose_office(page);
    await add_at(page, 'Waypoint', 70, 20);
    await page.getByText('is outside the map').waitFor();
    assert.ok(await page.getByRole('button', { name: 'Review plans' }).isDisabled());
    await page.getByRole('button', { name: 'Move it inside' }).click();
    await until(async () => (await page.getByText('is outside the map').count()) === 0, 'mended');
    await page.getByRole('button', { name: 'Delete task 1' }).click();
    await add_at(page, 'Waypoint', 16, 16);
    await page.getByText('seems out of reach').waitFor();
    await accessible(page, 'plan-problems');
    await page.getByRole('button', { name: 'Move it to the nearest place in reach' }).click();
    await until(async () => (await page.getByText('seems out of reach').count()) === 0, 'in reach');
  }));

test('from a description to a debrief, and the wizard learns of it', () =>
  with_page({ at: '/#/plan' }, async (page, mock) => {
    await choose_office(page);
    await add_at(page, 'Biohazard', 6, 15);
    await add_at(page, 'Waypoint', 34, 22);
    await page.getByRole('button', { name: 'Review plans' }).click();
    await page.getByText('Every robot does every task, in order.').waitFor();
    assert.deepEqual(mock.plans_asked[0], {
      map_name: 'office',
      request: {
        tasks: [{ task: 'biohazard', x: 6, y: 15 }, { task: 'waypoint', x: 34, y: 22 }],
        enemy: false, max_velocity_mps: 0.5, aggressiveness: 0.3, top: 3,
      },
    });
    await page.getByRole('button', { name: 'Preview', exact: true }).click();
    await page.getByText('10 of 10 flights flown').waitFor();
    await accessible(page, 'plan-review');
    await page.getByRole('radio').nth(1).check();
    await page.getByText('1 of 5', { exact: false }).or(page.getByText('4 of 5 features fit')).first().waitFor();
    await page.getByRole('radio').first().check();

    await page.getByRole('button', { name: 'Run this plan' }).click();
    await page.getByText('The plan was not previewed').waitFor();
    await accessible(page, 'plan-preflight');
    await page.getByLabel('Run it all the same').check();
    await page.getByRole('button', { name: 'Run', exact: true }).click();
    await page.locator('[data-robot]').first().waitFor();
    assert.equal(mock.started[0].map_name, 'office');
    assert.match(mock.started[0].mission, /bindArch/);
    await page.waitForTimeout(1500);
    await accessible(page, 'plan-run');
    await page.getByRole('button', { name: 'Abort the mission' }).click();
    await page.getByRole('button', { name: 'Press again to abort' }).click();

    await page.getByRole('heading', { name: 'Debrief' }).waitFor();
    await page.getByText('3 of 4 sub-tasks done').waitFor();
    await page.getByRole('button', { name: 'Tell the wizard' }).click();
    await page.getByText('The wizard has noted it').waitFor();
    assert.deepEqual(mock.outcomes[0].cases, [10, 11]);
    assert.equal(mock.outcomes[0].score, 0.75);
    assert.equal(mock.outcomes[0].failures.length, 1);
    await page.getByLabel('Title').fill('Office, seen through');
    await page.getByRole('button', { name: 'Store the case' }).click();
    await page.getByText('Stored 1 new case.').waitFor();
    assert.equal(mock.cases[0].features.length, 2);
    assert.equal(mock.cases[0].features[0].task, 'biohazard');
    await accessible(page, 'plan-debrief');
  }));

test('a preview is cancelled', () =>
  with_page({ at: '/#/plan' }, async (page, mock) => {
    await choose_office(page);
    await add_at(page, 'Waypoint', 34, 22);
    await page.getByRole('button', { name: 'Review plans' }).click();
    await page.getByLabel('Flights').selectOption('100');
    await page.getByRole('button', { name: 'Preview', exact: true }).click();
    await page.getByRole('button', { name: 'Cancel' }).click();
    await page.getByText('(cancelled)').waitFor();
    assert.equal(mock.previews.get('p1').state, 'cancelled');
  }));
