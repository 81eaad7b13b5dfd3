// The page, opened from disk in headless browsers: a mesh is dropped, loops are found, looked at and saved, handles
// are removed. BROWSER is chromium or firefox.

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { launch, newPage } from './browsers.mjs';
import { differenceOfFiles, folder, makeMeshes, native, nativeRun } from './meshes.mjs';
import * as pages from './pages.mjs';

const downloads = mkdtempSync(join(folder, 'downloads-'));
const requests = [];
let browser, page, complaints, meshes;

before(async () => {
  meshes = makeMeshes();
  browser = await launch(process.env.BROWSER, downloads);
  ({ page, complaints } = await newPage(browser));
  page.on('request', request => requests.push(request.url()));
  await page.goto(pathToFileURL(join(process.env.HTL_WEB, 'index.html')).href);
  await page.waitForSelector('body.ready');
});

after(() => browser?.close());

const message = () => pages.messageOf(page);
const viewer = async () => (await page.$('#viewer')).contentFrame();

const doing = action => pages.doing(page, action);
const open = file => doing(async () => (await page.$('#file')).uploadFile(join(folder, file)));
const press = selector => doing(() => page.click(selector));

async function isShown() {
  const frame = await viewer();
  await frame.waitForSelector('body.ready', { timeout: 60000 });
  return frame;
}

const drop = (name, text) => doing(() => page.evaluate((fileName, content) => {
  const files = new DataTransfer();
  files.items.add(new File([content], fileName));
  document.dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true }));
}, name, text));

async function saved(file) {
  const before = new Set(readdirSync(downloads));
  await doing(() => page.select('#save', file));
  for (let i = 0; i < 100; ++i) {
    const made = readdirSync(downloads).filter(name => !before.has(name));
    // Firefox makes the file first, empty, and beside it the one that it writes.
    if (made.length === 1 && !/\.(crdownload|part)$/.test(made[0]) && statSync(join(downloads, made[0])).size > 0)
      return join(downloads, made[0]);
    await new Promise(resolve => setTimeout(resolve, 100));
  }
  throw new Error(`${file} was not saved`);
}

test('a mesh that is dropped gets its loops, as the native tool finds them', async () => {
  await drop('bicycle.off', native('generate', 'bicycle', '--faces', '20000', '-o', '-', '-q').toString());
  assert.match(await message(), /genus 14/);
  const frame = await isShown();
  assert.equal(await frame.$$eval('#rows tr', rows => rows.length), 14);
});

test('what is saved is checked by the native tool', async () => {
  await open('lattice.obj');
  await isShown();
  const json = await saved('loops.json');
  assert.equal(nativeRun('check', 'lattice.obj', json).exitCode, 0);
  assert.match(readFileSync(await saved('table.csv'), 'utf8'), /^mesh,pair/m);
  assert.match(readFileSync(await saved('lines.obj'), 'utf8'), /^l /m);
  assert.equal(readFileSync(await saved('model.glb')).subarray(0, 4).toString(), 'glTF');
  assert.equal(readFileSync(await saved('picture.png')).subarray(1, 4).toString(), 'PNG');
});

test('twenty meshes, to the last bit', async () => {
  for (const mesh of meshes) {
    await open(mesh);
    const json = await page.evaluate(() => new TextDecoder().decode(window.app.results['loops.json']));
    native('loops', mesh, '-qo', 'native.json');
    assert.equal(differenceOfFiles(json, readFileSync(join(folder, 'native.json'))), null, mesh);
  }
});

test('chosen handles are removed, and the new mesh goes on', async () => {
  await open('lattice.obj');
  const frame = await isShown();
  for (const row of (await frame.$$('#rows tr input')).slice(0, 3))
    await row.click();
  await page.waitForFunction(() => window.app.chosen.length === 3, { timeout: 60000 });
  await press('#remove-chosen');
  assert.match(await message(), /genus 12 -> 9/);
  assert.deepEqual(await (await isShown()).$$eval('[name=surface]', nodes => nodes.length), 2);
  const stl = await saved('mesh.stl');
  assert.match(nativeRun('loops', stl).output, /genus 9 /);
  await doing(() => page.select('#save', 'go on'));
  assert.match(await message(), /genus 9/);
});

test('files have the names that a person would give them', async () => {
  await open('torus.off');
  const frame = await isShown();
  const { title, choice } = await frame.evaluate(() => ({ title: document.title, choice: window.htloops.scene.choice[0] }));
  assert.match(title, /torus\.off$/);
  assert.match(choice, /^htloops remove torus.off --loops torus-loops.json --pairs $/);
  await drop('-two words.off', native('generate', 'torus', '--faces', '500', '-o', '-', '-q').toString());
  assert.match(await (await isShown()).evaluate(() => window.htloops.scene.choice[0]), /--loops two_words-loops.json --pairs $/);
  await press('#remove-genus');
  await doing(() => page.select('#save', 'go on'));
  assert.equal(await page.$eval('#name', node => node.textContent), 'two_words-mesh.stl');
});

test('narrow screens and dark ones', async () => {
  await open('torus.off');
  for (const width of [320, 390, 768]) {
    await page.setViewport({ width, height: 640 });
    const { wide, high, finger } = await page.evaluate(() => ({
      wide: document.documentElement.scrollWidth, high: document.querySelector('main').clientHeight,
      finger: Math.min(...[...document.querySelectorAll('header button')].map(node => node.clientHeight)),
    }));
    assert.ok(wide <= width, `${wide} of ${width} pixels`);
    assert.ok(high > 0.45 * 640, `${high} pixels for the result, of ${width} across`);
    assert.ok(finger >= 32, `${finger} pixels for a thumb`);
  }
  await page.setViewport({ width: 1300, height: 850 });
  if (process.env.BROWSER === 'chromium') { // the driver of the other has no such wish
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: 'dark' }]);
    assert.equal(await paper(), 'rgb(23, 25, 29)');
    await page.emulateMediaFeatures([]);
    assert.equal(await paper(), 'rgb(255, 255, 255)');
  }
});

test('all samples are there', async () => {
  const samples = await page.$$eval('#sample option', nodes => nodes.map(({ value }) => value).filter(value => value));
  assert.equal(samples.length, 6);
  for (const sample of samples) {
    await doing(() => page.select('#sample', sample));
    assert.match(await message(), /^genus \d+/, sample);
    await isShown();
  }
});

test('the other tasks are shown, too', async () => {
  await open('multi-torus.stl');
  for (const task of ['measure', 'reeb', 'skeleton', 'clean', 'cut']) {
    await press(`#task-${task}`);
    assert.equal(await page.$eval('#message', node => node.className), '', `${task}: ${await message()}`);
    await isShown();
  }
  await page.$eval('#remove-genus-value', node => { node.value = '1'; });
  await press('#remove-genus');
  assert.match(await message(), /genus 3 -> 1/);
});

test('what a mesh lacks is said, with a button that helps', async () => {
  await drop('quads.obj', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n' +
             'f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n');
  assert.match(await message(), /triangulate/);
  await press('#remedies button');
  assert.equal(await page.$eval('#message', node => node.className), '');
});

test('a hostile name is a text', async () => {
  const name = '<img src=x onerror="window.hurt = 1">&@script@.off';
  await drop(name, native('generate', 'torus', '--faces', '500', '-o', '-', '-q').toString());
  const frame = await isShown();
  assert.ok((await page.$eval('#name', node => node.textContent)).includes('<img'));
  assert.ok(!(await page.evaluate(() => window.hurt)) && !(await frame.evaluate(() => window.hurt)));
  assert.ok((await frame.$eval('h1', node => node.textContent)).includes('<img'));
});

test('what is no mesh is said, and the page goes on', async () => {
  await drop('nothing.off', 'OFF\n3 1 0\n');
  assert.equal(await page.$eval('#message', node => node.className), 'error');
  const words = await page.evaluate(() => window.app.run('too large', ['generate', 'torus', '--faces', '600000000',
                                                                        '-o', 'x.off'], {}).then(r => r.messages));
  assert.match(words, /memory/);
  await open('torus.off');
  assert.match(await message(), /genus 1/);
});

test('Cancel ends it within a fifth of a second', () => pages.checkCancel(page));

test('nothing was asked of any server, and nothing was complained of', () => {
  assert.deepEqual(requests.filter(url => !/^(file|blob|data|about):/.test(url)), []);
  assert.deepEqual(complaints, []);
});
