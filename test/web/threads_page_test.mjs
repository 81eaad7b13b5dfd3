// The page with threads, served with the headers that it needs, and without. BROWSER is chromium or firefox.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { isolated, launch, newPage, serve } from './browsers.mjs';
import { differenceOfFiles, folder, makeMeshes, native } from './meshes.mjs';

let browser;

before(async () => { browser = await launch(process.env.BROWSER); });
after(() => browser?.close());

// The page, as it is served with these headers, and what it asks the server for.
async function opened(headers, use) {
  const server = await serve(process.env.HTL_WEB, headers), { page, complaints } = await newPage(browser);
  const requests = [];
  page.on('request', request => requests.push(request.url()));
  const address = `${server.address}/threads.html`;
  await page.goto(address);
  await use(page);
  await page.close();
  server.close();
  assert.deepEqual(requests.filter(url => !/^(blob|data|about):/.test(url)), [address]);
  assert.deepEqual(complaints, []);
}

async function doing(page, action) {
  const done = await page.evaluate(() => window.app.done);
  await action();
  await page.waitForFunction(count => window.app.done > count && !window.app.isBusy, { timeout: 120000 }, done);
}

test('it computes in as many threads as there are processors, and finds what the native tool does', () =>
  opened(isolated, async page => {
    await page.waitForSelector('body.ready');
    const processors = await page.evaluate(() => navigator.hardwareConcurrency);
    for (const mesh of makeMeshes(6)) {
      await doing(page, async () => (await page.$('#file')).uploadFile(join(folder, mesh)));
      const json = await page.evaluate(() => new TextDecoder().decode(window.app.results['loops.json']));
      assert.equal(JSON.parse(json).threads, processors);
      assert.equal(differenceOfFiles(json, native('loops', mesh, '-qo', '-')), null, mesh);
    }
    const frame = await (await page.$('#viewer')).contentFrame();
    await frame.waitForSelector('body.ready', { timeout: 60000 });
  }));

test('Cancel ends it within a fifth of a second, and it goes on', () => opened(isolated, async page => {
  await page.waitForSelector('body.ready');
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
  }
  assert.ok(Math.min(...times) < 200, `${times} ms`);
  await doing(page, () => page.evaluate(() => { window.app.perform(() => window.app.generate('small', ['torus', '--faces', '2000'])); }));
  assert.match(await page.$eval('#message', node => node.textContent), /genus 1/);
}));

test('without the headers it says what it needs', () => opened({}, async page => {
  assert.match(await page.$eval('#refusal', node => node.innerText), /Cross-Origin-Embedder-Policy: require-corp/);
  assert.equal(await page.evaluate(() => window.app), undefined);
}));
