// The page of --html, used as a person uses it: clicks, keys, fingers, another window, another colour scheme, no
// graphics card. BROWSER is chromium or firefox.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import assert from 'node:assert/strict';
import { pathToFileURL } from 'node:url';
import { launch, modules, newPage } from './browsers.mjs';

const browserName = process.env.BROWSER ?? 'chromium', folder = mkdtempSync(join(tmpdir(), 'viewer-'));
const axe = readFileSync(createRequire(join(modules, '/')).resolve('axe-core/axe.min.js'), 'utf8');
const inFolder = name => join(folder, name);
const htloops = (...words) => execFileSync(process.env.HTLOOPS, words, { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });

let browser, page, complaints;

before(async () => {
  htloops('generate', 'multi-torus', '--genus', '5', '--faces', '8000', '-q', '-o', 'part.off');
  htloops('loops', 'part.off', '-q', '--html', 'loops.html');
  htloops('generate', 'gyroid', '--genus', '8', '--faces', '20000', '-q', '-o', 'gyroid.off');
  htloops('loops', 'gyroid.off', '-q', '--html', 'gyroid.html');
  htloops('remove', 'part.off', '-q', '--all', '-o', 'removed.off', '--html', 'removal.html');
  htloops('skeleton', 'part.off', '-q', '--html', 'skeleton.html');
  htloops('reeb', 'part.off', '-q', '--html', 'reeb.html');
  htloops('measure', 'part.off', '-q', '--html', 'measures.html');
  htloops('generate', 'sphere', '--faces', '500', '-q', '-o', 'sphere.off');
  htloops('loops', 'sphere.off', '-q', '--html', 'empty.html');
  browser = await launch(browserName, folder);
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

const settled = () => page.evaluate(() => window.htloops.viewer.settled());
const isReady = () => page.waitForFunction(() => document.body.classList.contains('ready'), { timeout: 60000 });

// Opens a page in a window of its own; `prepare` is run in it before anything else.
async function open(name, { width = 1400, height = 900, scheme = 'light', motion = 'no-preference', prepare } = {}) {
  ({ page, complaints } = await newPage(browser));
  await page.setViewport({ width, height });
  if (browserName === 'chromium')
    await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }, { name: 'prefers-reduced-motion', value: motion }]);
  if (prepare)
    await page.evaluateOnNewDocument(prepare);
  await page.goto(pathToFileURL(inFolder(name)).href);
  await isReady();
  await settled();
}

async function close() {
  assert.deepEqual(complaints, []);
  await page.close();
}

const evaluate = (...words) => page.evaluate(...words);
const text = selector => page.$eval(selector, node => node.textContent);
const pose = () => evaluate(() => structuredClone(window.htloops.viewer.camera.pose));
const distanceOf = (a, b) => Math.max(...Object.keys(a).flatMap(key => [a[key]].flat().map((x, k) => Math.abs(x - [b[key]].flat()[k]))));
const rowsShown = () => evaluate(() => [...document.querySelectorAll('#rows tr')].filter(row => !row.hidden).length);
const clickRow = number => page.click(`#rows tr:nth-child(${number}) td:nth-child(3)`);

// What is seen in the middle of the picture, as colours.
const pixels = () => evaluate(() => {
  const { viewer } = window.htloops, { gl } = viewer.renderer, { width, height } = viewer.canvas, data = new Uint8Array(4 * width * height);
  viewer.drawNow();
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  let surface = 0, handle = 0;
  const background = viewer.background.map(x => Math.round(255 * x));
  for (let i = 0; i < data.length; i += 4) {
    surface += background.some((x, k) => Math.abs(data[i + k] - x) > 3) ? 1 : 0;
    handle += data[i] > data[i + 2] + 80 ? 1 : 0;
  }
  return { surface: surface / (width * height), handle };
});

const windows = { large: [1400, 900], small: [800, 600], phone: [400, 800] };

for (const [name, where, scheme] of [
  ['loops', 'large', 'light'], ['loops', 'small', 'dark'], ['loops', 'phone', 'light'], ['removal', 'large', 'dark'],
  ['removal', 'phone', 'light'], ['skeleton', 'large', 'light'], ['skeleton', 'phone', 'dark'], ['reeb', 'small', 'light'],
  ['measures', 'large', 'dark'], ['empty', 'large', 'light'], ['empty', 'phone', 'dark']])
  test(`everybody can use it: ${name}, ${where}, ${scheme}`, async () => {
    const [width, height] = windows[where];
    await open(`${name}.html`, { width, height, scheme });
    await page.evaluate(axe);
    for (const prepare of [() => {}, () => document.getElementById('sheet').click(),
                           () => { document.querySelector('.menu').open = true; window.htloops.page.light(0, false); }]) {
      await page.evaluate(prepare);
      const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
      assert.deepEqual(violations.map(v => `${v.id}: ${v.nodes.map(node => node.html.slice(0, 120)).slice(0, 3).join(' | ')}`), []);
    }
    assert.ok(await evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'it is as wide as the window');
    await close();
  });

test('the model comes first', async () => {
  await open('loops.html');
  const share = await evaluate(() => document.querySelector('main').clientWidth / innerWidth);
  assert.ok(share > 0.66, `${share}`);
  const width = () => evaluate(() => document.querySelector('aside').clientWidth), wide = await width();
  await page.type('#search', 'nothing has this');
  assert.equal(await rowsShown(), 0);
  assert.equal(await width(), wide); // whatever is hidden
  assert.ok((await pixels()).surface > 0.2);
  await close();
});

test('a click on a row flies there, and Escape or Back returns', async () => {
  for (const back of [() => page.keyboard.press('Escape'), () => page.click('#back')]) {
    await open('gyroid.html');
    const before = await pose();
    assert.equal(await evaluate(() => {
      document.querySelectorAll('#rows tr')[2].click();
      return Boolean(window.htloops.viewer.flight);
    }), true); // it takes a while
    const during = await pose();
    await settled();
    const there = await pose();
    assert.notDeepEqual(there, before);
    assert.notDeepEqual(there, during);
    assert.ok((await pixels()).handle > 50, 'its handle loop is seen');
    await back();
    await settled();
    assert.ok(distanceOf(await pose(), before) < 1e-9);
    assert.equal(await evaluate(() => document.getElementById('back').disabled), true);
    await close();
  }
});

test('where an eye is asked for there is no wall before it', async () => {
  await open('gyroid.html');
  for (let row = 1; row <= 8; ++row) {
    await clickRow(row);
    await settled();
    const { distance, front, hit } = await evaluate(() => {
      const { viewer } = window.htloops, { camera } = viewer, { eye } = camera.ray(0, 0);
      const place = viewer.placeAt(viewer.canvas.clientWidth / 2, viewer.canvas.clientHeight / 2);
      return { distance: camera.distance, front: camera.front, hit: place && Math.hypot(...eye.map((x, k) => x - place[k])) };
    });
    assert.ok(hit === null || hit > distance - front - 1e-6, `row ${row}: ${hit} ${distance} ${front}`);
    assert.ok((await pixels()).handle > 20, `row ${row}`);
  }
  await close();
});

test('who wants no motion gets none', { skip: browserName !== 'chromium' && 'not to be asked for' }, async () => {
  await open('loops.html', { motion: 'reduce' });
  const before = await pose();
  await clickRow(2);
  assert.equal(await evaluate(() => Boolean(window.htloops.viewer.flight)), false);
  assert.notDeepEqual(await pose(), before);
  await close();
});

test('Reset resets all, and keeps what was selected', async () => {
  await open('loops.html');
  const before = await pose();
  await page.click('#rows tr:nth-child(2) input');
  await clickRow(2);
  await evaluate(() => {
    const set = (id, value, event) => {
      document.getElementById(id).value = value;
      document.getElementById(id).dispatchEvent(new Event(event));
    };
    set('cut', 400, 'input');
    set('opacity', 30, 'input');
    set('search', 'zzz', 'input');
    set('longest', 0, 'input');
    set('up', 'x', 'change');
    document.getElementById('wire').click();
    document.getElementById('group0').click();
    document.querySelector('#colours input').click();
  });
  await settled();
  await page.click('#reset');
  await settled();
  assert.deepEqual(await pose(), before);
  assert.deepEqual(await evaluate(() => {
    const { cut, opacity, isWired } = window.htloops.viewer, value = id => document.getElementById(id).value;
    return [cut.part, opacity, isWired, value('cut'), value('opacity'), value('search'), value('up'), document.getElementById('group0').checked,
            document.querySelector('#colours input').checked, window.htloops.page.lit];
  }), [1, 1, false, '1000', '100', '', '', true, false, 1]);
  assert.equal(await rowsShown(), 5);
  assert.match(await page.$eval('#choice', node => node.value), /^htloops remove part\.off --pairs \d -o part_without_them\.ply$/);
  await close();
});

test('what is copied is a command that works', async () => {
  await open('loops.html');
  await page.click('#rows tr:nth-child(1) input');
  await page.click('#rows tr:nth-child(3) input');
  const [program, ...words] = (await page.$eval('#choice', node => node.value)).split(' ');
  assert.equal(program, 'htloops');
  assert.match(htloops(...words).toString(), /2 removed|removed 2|genus 3/);
  assert.ok(readdirSync(folder).includes('part_without_them.ply'));
  await close();
});

test('rows are found by words and by numbers, and hidden by sliders and by fields', async () => {
  await open('loops.html');
  const lengths = (await evaluate(() => window.htloops.scene.rows.map(cells => Number(cells[1])))).sort((a, b) => a - b);
  const search = async words => {
    await page.$eval('#search', (node, value) => {
      node.value = value;
      node.dispatchEvent(new Event('input'));
    }, words);
    return rowsShown();
  };
  assert.equal(await search(`handle <= ${lengths[2]}`), 3);
  assert.equal(await search(`handle > ${lengths[2]}`), 2);
  assert.equal(await search('of = handle'), await search('handle'));
  assert.equal(await search('pair = 4'), 1);
  assert.equal(await search(`handle > ${lengths[0]}, pair = 99`), 0);
  for (const unfinished of ['handle <', '<', '=', 'nothing < 2', 'handle < ,', 'handle < x'])
    assert.equal(await search(unfinished), 5, unfinished);
  await search('pair = 4'); // the tabulator still reaches the table
  assert.equal(await evaluate(() => [...document.querySelectorAll('#rows tr')].filter(row => !row.hidden && row.tabIndex === 0).length), 1);
  assert.equal(await search(''), 5);
  assert.equal(await text('#shortest-words'), 'shortest loop shown');
  await page.$eval('#shortest-value', (node, value) => {
    node.value = value;
    node.dispatchEvent(new Event('change'));
  }, lengths[1] * 1.0000001);
  assert.ok(await rowsShown() < 5);
  await page.select('#scale', '1');
  assert.equal(await rowsShown(), 5);
  await close();
});

test('the surface is cut from all sides, and shows its edges', async () => {
  await open('loops.html');
  const { surface } = await pixels();
  for (const direction of ['x', 'y', 'z', '-x', '-y', '-z', 'eye']) {
    await page.select('#axis', direction);
    await page.$eval('#cut', node => {
      node.value = 300;
      node.dispatchEvent(new Event('input'));
    });
    await settled();
    assert.ok((await pixels()).surface < 0.98 * surface, direction);
  }
  await page.click('#reset');
  await settled();
  assert.ok(Math.abs((await pixels()).surface - surface) < 0.01);
  await page.focus('#canvas');
  await page.keyboard.press('w');
  assert.equal(await evaluate(() => window.htloops.viewer.isWired), true);
  await close();
});

test('a double click sets what it turns about, and distances are those of the mesh', async () => {
  await open('loops.html');
  const place = await evaluate(() => {
    const { viewer } = window.htloops, { clientWidth, clientHeight } = viewer.canvas;
    for (let x = 0.2; x < 0.8; x += 0.02)
      for (let y = 0.2; y < 0.8; y += 0.02)
        if (viewer.placeAt(x * clientWidth, y * clientHeight))
          return [x * clientWidth, y * clientHeight];
    return null;
  });
  const before = await pose();
  await page.mouse.click(...place, { count: 2 });
  await settled();
  assert.notDeepEqual((await pose()).place, before.place);
  await page.keyboard.press('0');
  await settled();
  await page.click('#measure');
  assert.match(await text('#note'), /two points/);
  await page.mouse.click(...place);
  await new Promise(resolve => setTimeout(resolve, 500)); // or they are one double click
  await page.mouse.click(place[0] + 20, place[1]);
  const { measured, expected } = await evaluate(() => {
    const { page: { overlay }, viewer, scene } = window.htloops, [a, b] = overlay.ends;
    const steps = p => p.map((x, k) => (x - viewer.placing.shift[k]) / viewer.placing.scale[k]);
    const extents = scene.size.map(x => x * scene.extent / Math.max(...scene.size)), [u, v] = [steps(a), steps(b)];
    return { measured: overlay.lengthMeasured, expected: Math.hypot(...u.map((x, k) => (x - v[k]) / 65535 * extents[k])) };
  });
  assert.ok(measured > 0 && Math.abs(measured - expected) < 1e-6 * expected, `${measured} ${expected}`);
  await page.keyboard.press('Escape');
  assert.equal(await page.$eval('#measure', node => node.getAttribute('aria-pressed')), 'false');
  await close();
});

test('what is pointed at is told, and a click lights it', async () => {
  await open('loops.html');
  const place = await evaluate(() => {
    const { viewer, scene } = window.htloops;
    for (const [i, line] of scene.lines.entries())
      for (const p of viewer.pointsOfLine(line)) {
        const [x, y] = viewer.project(p);
        if (viewer.pick(x, y) === i)
          return [x, y, line.row];
      }
    return null;
  });
  await page.mouse.move(place[0] + 3, place[1]);
  await page.mouse.move(place[0], place[1]);
  await page.waitForFunction(() => !document.getElementById('tip').hidden, { timeout: 5000 });
  assert.match(await text('#tip'), /^pair \d+\nhandle [\d.]+\ntunnel [\d.]+/);
  await page.mouse.click(place[0], place[1]);
  assert.equal(await evaluate(() => window.htloops.page.lit), place[2]);
  assert.match(await text('#card h2'), /^pair \d+$/);
  await close();
});

test('Back leads to where one meant to be, not to where one was on the way', async () => {
  await open('gyroid.html');
  const poses = [await pose()];
  await evaluate(() => window.htloops.page.light(0, true));
  await evaluate(() => window.htloops.page.light(1, true)); // during the flight
  await settled();
  await page.click('#back');
  await settled();
  const first = await pose();
  await evaluate(() => window.htloops.page.light(0, true));
  await settled();
  assert.ok(distanceOf(await pose(), first) < 1e-9);
  await page.click('#back');
  await settled();
  await page.click('#back');
  await settled();
  assert.ok(distanceOf(await pose(), poses[0]) < 1e-9);
  await close();
});

test('a double click keeps what was selected, and what is upright goes back, too', async () => {
  await open('loops.html');
  await evaluate(() => window.htloops.page.light(2, false));
  const { canvas } = await evaluate(() => ({ canvas: [window.htloops.viewer.canvas.clientWidth / 2, window.htloops.viewer.canvas.clientHeight / 2] }));
  await page.mouse.click(...canvas, { count: 2 });
  await settled();
  assert.equal(await evaluate(() => window.htloops.page.lit), 2);
  await page.select('#up', 'x');
  await settled();
  await page.click('#back');
  await settled();
  assert.equal(await page.$eval('#up', node => node.value), '');
  await close();
});

test('keys do all that the mouse does', async () => {
  await open('loops.html');
  await page.focus('#rows tr');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press(' ');
  await page.keyboard.press('Enter');
  await settled();
  assert.equal(await evaluate(() => window.htloops.page.lit), 1);
  assert.equal(await evaluate(() => window.htloops.page.table.chosen.length), 1);
  await page.focus('#canvas');
  const before = await pose();
  for (const key of ['ArrowLeft', 'ArrowUp', '+', '.'])
    await page.keyboard.press(key);
  await settled();
  assert.notDeepEqual(await pose(), before);
  await page.keyboard.press('n');
  assert.equal(await evaluate(() => window.htloops.page.lit), 2);
  await close();
});

// The pictures that have been saved.
async function saved(width, height) {
  for (let i = 0; i < 1200; ++i) {
    const name = readdirSync(folder).find(file => /^part.*\.png$/.test(file));
    const bytes = name ? readFileSync(inFolder(name)) : Buffer.alloc(0);
    if (bytes.length > 24 && bytes.readUInt32BE(16) === width && bytes.readUInt32BE(20) === height)
      return rmSync(inFolder(name));
    await new Promise(resolve => setTimeout(resolve, 50));
  }
  return assert.fail('no picture of that size');
}

test('what takes long is drawn at once, then in steps with smooth rims, and gives way to what is done meanwhile', async () => {
  await open('gyroid.html');
  const seen = await evaluate(async () => {
    const { viewer } = window.htloops, { renderer } = viewer, { gl } = renderer, { copy } = renderer, frames = [];
    renderer.copy = function (...words) {
      copy.apply(this, words);
      if (words[2] !== null)
        return;
      const data = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, data);
      frames.push(data);
    };
    const differences = (a, b) => a.reduce((all, x, i) => all + (Math.abs(x - b[i]) > 3 ? 1 : 0), 0) / a.length;
    const slow = { frame: 1e6, triangle: 0 };
    Object.assign(viewer.costs, { frame: 0, triangle: 0 });
    viewer.drawNow();
    Object.assign(viewer.costs, slow);
    viewer.drawNow();
    await viewer.settled();
    const [smooth, plain, steps] = frames, number = frames.length;
    Object.assign(viewer.costs, slow);
    viewer.drawNow();
    viewer.camera.turn(1, 0.3);
    viewer.move(); // while that is refined
    await viewer.settled();
    const last = frames[frames.length - 1];
    Object.assign(viewer.costs, { frame: 0, triangle: 0 });
    viewer.drawNow();
    return { number, sameAsAtOnce: differences(smooth, steps), plain: differences(smooth, plain),
             turned: differences(smooth, last), sameAfterTurn: differences(last, frames[frames.length - 1]) };
  });
  assert.equal(seen.number, 3);
  assert.equal(seen.sameAsAtOnce, 0);
  assert.ok(seen.plain > 0 && seen.plain < 0.2, `rims only: ${seen.plain}`);
  assert.ok(seen.turned > 0.05);
  assert.equal(seen.sameAfterTurn, 0);
  await close();
});

test('the keyboard goes on at the surface when what had it goes', async () => {
  await open('loops.html');
  const focused = () => evaluate(() => document.activeElement.id);
  await clickRow(2);
  await settled();
  await page.focus('#back');
  await page.keyboard.press('Enter');
  await settled();
  assert.equal(await focused(), 'canvas');
  await page.focus('#card button');
  await page.keyboard.press('Escape');
  await settled();
  assert.equal(await focused(), 'canvas');
  await close();
});

test('pictures are saved in any size', async () => {
  await open('loops.html');
  const save = (width, height, isClear) => evaluate((...all) => {
    const [width, height, isClear] = all;
    document.getElementById('width').value = width;
    document.getElementById('height').value = height;
    document.getElementById('clear-background').checked = isClear;
    window.htloops.page.saving.save();
  }, width, height, isClear);
  await save(700, 500, false);
  await saved(700, 500);
  await save(100000, 20, false);
  assert.match(await text('#note'), /pixels on a side/);
  await save(1920, 1080, true);
  await saved(1920, 1080);
  const corners = await evaluate(() => {
    const { viewer } = window.htloops, { data } = viewer.renderer.image(viewer, 64, 64, [0, 0, 0, 0]), middle = 4 * (64 * 32);
    const most = Math.max(...data.filter((_, i) => i % 4 === 3));
    return [data[3], most, middle];
  });
  assert.deepEqual(corners.slice(0, 2), [0, 255]);
  await close();
});

test('it follows its window', async () => {
  await open('loops.html');
  for (const [width, height] of [[900, 700], [420, 800], [1400, 900]]) {
    await page.setViewport({ width, height });
    await evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
    await settled();
    const { size, shown } = await evaluate(() => {
      const { canvas } = window.htloops.viewer;
      return { size: [canvas.width, canvas.height], shown: [canvas.clientWidth, canvas.clientHeight].map(x => Math.round(x * devicePixelRatio)) };
    });
    assert.deepEqual(size, shown);
    assert.ok((await pixels()).surface > 0.1);
  }
  await close();
});

test('a lost graphics card comes back', async () => {
  await open('loops.html');
  const before = await pixels();
  await evaluate(() => {
    window.card = window.htloops.viewer.renderer.gl.getExtension('WEBGL_lose_context');
    window.card.loseContext();
  });
  await page.waitForFunction(() => /graphics card/.test(document.getElementById('message').textContent));
  await clickRow(2); // the table works
  assert.equal(await evaluate(() => window.htloops.page.lit), 1);
  await evaluate(() => window.card.restoreContext());
  await page.waitForFunction(() => document.getElementById('message').textContent === '');
  await evaluate(() => {
    window.htloops.page.light(-1);
    window.htloops.viewer.goHome();
  });
  await settled();
  assert.ok(Math.abs((await pixels()).surface - before.surface) < 0.01);
  complaints = complaints.filter(words => !/CONTEXT_LOST|context lost|WebGL context was lost/i.test(words));
  await close();
});

test('without WebGL the table works, and words say so', async () => {
  await open('loops.html', { prepare: () => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind.startsWith('webgl') ? null : getContext.call(this, kind, ...rest);
    };
  } });
  assert.match(await text('#message'), /cannot be drawn here.*WebGL 2.*table works/);
  assert.equal(await rowsShown(), 5);
  await page.click('#head th:nth-child(3) button');
  await clickRow(1);
  await page.click('#rows tr:nth-child(1) input');
  assert.match(await page.$eval('#choice', node => node.value), /--pairs \d/);
  await page.click('#reset');
  await close();
});

test('no loops: a sentence says why', async () => {
  await open('empty.html');
  assert.match(await text('#empty'), /no handles.*genus is 0/);
  assert.equal(await page.$eval('#table', node => node.hidden), true);
  assert.ok((await pixels()).surface > 0.1);
  await close();
});

test('on a phone all is reached, by fingers', async () => {
  await open('loops.html', { width: 400, height: 800 });
  const size = () => evaluate(() => parseFloat(getComputedStyle(document.querySelector('#rows td')).fontSize));
  assert.equal(await page.$eval('#more', node => getComputedStyle(node).display), 'none');
  await page.click('#sheet');
  assert.notEqual(await page.$eval('#more', node => getComputedStyle(node).display), 'none');
  assert.ok(await size() >= 14);
  const tops = await evaluate(() => ['longest', 'rows'].map(id => document.getElementById(id).getBoundingClientRect().top));
  assert.ok(tops[0] < tops[1] && tops[0] < 800, 'sliders are above the table, and seen');
  assert.ok(await evaluate(() => document.querySelector('main').clientHeight > 200), 'the model is still there');
  await clickRow(1);
  await settled();
  assert.equal(await evaluate(() => window.htloops.page.lit), 0);
  await close();
});
