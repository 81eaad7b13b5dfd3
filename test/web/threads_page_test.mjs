// The page with threads, served with the headers that it needs, and without. BROWSER is chromium or firefox.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { isolated, launch, newPage, serve } from './browsers.mjs';
import { differenceOfFiles, folder, makeMeshes, native } from './meshes.mjs';
import { checkCancel, doing, messageOf } from './pages.mjs';

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
  await checkCancel(page);
  await doing(page, () => page.evaluate(() => { window.app.perform(() => window.app.generate('small', ['torus', '--faces', '2000'])); }));
  assert.match(await messageOf(page), /genus 1/);
}));

test('without the headers it says what it needs', () => opened({}, async page => {
  assert.match(await page.$eval('#refusal', node => node.innerText), /Cross-Origin-Embedder-Policy: require-corp/);
  assert.equal(await page.evaluate(() => window.app), undefined);
}));
