// The npm package in a browser: as it is, served from a folder, and through a bundler; without threads and with them.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { isolated, launch, modules, newPage, serve } from './browsers.mjs';
import { installInto } from './installed.mjs';
import { folder, native } from './meshes.mjs';

const home = join(folder, 'application');
let browser;

const program = from => `
  import { loops, generate, HtloopsError } from '${from}';
  const mesh = await generate('multi-torus', { genus: 2, faces: 2000 });
  const { pairs, threads } = await loops(mesh);
  const refused = await loops({ points: [], triangles: [0, 1, 2] }).catch(error => error instanceof HtloopsError);
  window.answer = { lengths: pairs.flatMap(({ handle, tunnel }) => [handle.length, tunnel.length]), refused,
                    threads, processors: navigator.hardwareConcurrency };
`;

before(async () => {
  installInto(home);
  browser = await launch(process.env.BROWSER);
});

after(() => browser?.close());

async function answerIn(root, path, headers) {
  const server = await serve(root, headers), { page, complaints } = await newPage(browser);
  await page.goto(`${server.address}/${path}`);
  await page.waitForFunction(() => window.answer, { timeout: 120000 });
  const answer = await page.evaluate(() => window.answer);
  await page.close();
  server.close();
  assert.deepEqual(complaints, []);
  return answer;
}

function check({ lengths, refused, threads, processors }, hasThreads) {
  native('generate', 'multi-torus', '--genus', '2', '--faces', '2000', '-q', '-o', 'two.off');
  const { pairs } = JSON.parse(native('loops', 'two.off', '-qo', '-'));
  assert.deepEqual(lengths, pairs.flatMap(({ handle, tunnel }) => [handle.length, tunnel.length]));
  assert.equal(refused, true);
  assert.equal(threads, hasThreads ? processors : 1);
}

async function checkBoth(root, path) {
  check(await answerIn(root, path), false);
  check(await answerIn(root, path, isolated), true);
}

test('as it is, from a folder that is served', async () => {
  writeFileSync(join(home, 'plain.html'), '<!DOCTYPE html><link rel="icon" href="data:,"><script type="module">' +
                `${program('./node_modules/handle-tunnel-loops/browser.js')}</script>`);
  await checkBoth(home, 'plain.html');
});

test('through a bundler', { skip: !existsSync(join(modules, 'vite')) }, async () => {
  writeFileSync(join(home, 'index.html'), '<!DOCTYPE html><link rel="icon" href="data:,"><script type="module" src="/main.js"></script>');
  writeFileSync(join(home, 'main.js'), program('handle-tunnel-loops'));
  writeFileSync(join(home, 'vite.config.js'), 'export default { build: { target: "esnext" }, worker: { format: "es" } };\n');
  execFileSync('node', [join(modules, 'vite/bin/vite.js'), 'build', '--logLevel', 'error'], { cwd: home });
  await checkBoth(join(home, 'dist'), 'index.html');
});
