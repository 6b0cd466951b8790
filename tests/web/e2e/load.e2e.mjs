import assert from 'node:assert/strict';
import { test } from 'node:test';
import { shot, with_page } from './page.mjs';

const kRobots = 100;
const kFor_ms = 8000;

/** Frames while a hundred robots come 20 times a second, all trails and numbers shown. */
test('a hundred robots at 20 Hz', () =>
  with_page({ robots: kRobots }, async (page) => {
    await page.locator('[data-robot]').nth(kRobots - 1).waitFor();
    await page.keyboard.press('n');
    const frames = await page.evaluate(
      (for_ms) =>
        new Promise((done) => {
          const times = [];
          const long = [];
          new PerformanceObserver((list) => long.push(...list.getEntries().map((one) => one.duration)))
            .observe({ entryTypes: ['longtask'] });
          const begin = performance.now();
          let last = begin;
          const frame = (now) => {
            times.push(now - last);
            last = now;
            if (now - begin < for_ms) requestAnimationFrame(frame);
            else done({ times: times.slice(1), long });
          };
          requestAnimationFrame(frame);
        }),
      kFor_ms,
    );
    const sorted = [...frames.times].sort((a, b) => a - b);
    const at = (share) => sorted[Math.floor(share * (sorted.length - 1))];
    console.log(
      `# 100 robots at 20 Hz: ${sorted.length} frames in ${kFor_ms / 1000} s, median ${at(0.5).toFixed(1)} ms, ` +
        `95 % ${at(0.95).toFixed(1)} ms, longest ${at(1).toFixed(1)} ms; long tasks ${frames.long.length}`,
    );
    await shot(page, 'hundred');
    assert.ok(at(0.5) < 50, 'each message is shown before the next comes');
  }));
