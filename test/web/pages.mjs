// What is done with the page that computes, in a browser.

import assert from 'node:assert/strict';

export const messageOf = page => page.$eval('#message', node => node.textContent);

// Waits until the page has done what an action makes it do.
export async function doing(page, action) {
  const before = await page.evaluate(() => window.app.done);
  await action();
  await page.waitForFunction(count => window.app.done > count && !window.app.isBusy, { timeout: 120000 }, before);
}

export async function checkCancel(page) {
  const times = [];
  for (let i = 0; i < 5; ++i) { // of which others on the machine may disturb some
    await page.evaluate(() => { window.app.perform(() => window.app.generate('large', ['gyroid', '--faces', '2000000'])); });
    await new Promise(resolve => setTimeout(resolve, 400));
    times.push(await page.evaluate(async () => {
      const began = performance.now();
      document.getElementById('cancel').click();
      while (window.app.isBusy)
        await new Promise(resolve => setTimeout(resolve, 1));
      return performance.now() - began;
    }));
    assert.match(await messageOf(page), /Cancelled/);
  }
  assert.ok(Math.min(...times) < 200, `${times} ms`);
}
