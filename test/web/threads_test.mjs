// The module with threads, in node: the same files as without them, and nothing of them is left where a run has ended.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';

import { installInto } from './installed.mjs';
import { bytesOf, differenceOfFiles, folder, makeMeshes, native, nativeRun } from './meshes.mjs';

const home = join(folder, 'threads');
let installed, htl, meshes;

before(async () => {
  installed = installInto(home);
  htl = await import(join(installed, 'node.js'));
  meshes = makeMeshes(8);
});

const command = (...args) =>
  spawnSync(join(home, 'node_modules/.bin/htloops'), args, { cwd: folder, maxBuffer: 1 << 28 });

// What the module without threads makes of a mesh: it is in the package for browsers.
async function withoutThreads(name, options) {
  const { default: create } = await import(join(installed, 'htloops.js'));
  const { runTool } = await import(join(installed, 'tool.js'));
  const code = await WebAssembly.compile(readFileSync(join(installed, 'htloops.wasm')));
  const { exitCode, fs } = await runTool({
    create, code, args: ['loops', name, ...options, '-q', '-o', 'loops.json'], environment: {},
    streams: { terminals: [], read: () => 0, write() {} },
    prepare: system => system.writeFile(name, bytesOf(name)),
  });
  assert.equal(exitCode, 0);
  return fs.readFile('loops.json', { encoding: 'utf8' });
}

test('the same files as without threads, to the last bit, for any number of them', async () => {
  for (const mesh of meshes) {
    const options = ['multi-torus.stl', 'gyroid.ply'].includes(mesh) ? ['--measure'] : [];
    const plain = await withoutThreads(mesh, options);
    assert.equal(JSON.parse(plain).threads, 1);
    for (const number of [2, 5]) {
      const { status, stderr } =
        command('loops', mesh, ...options, '-q', '--threads', String(number), '-o', 'many.json');
      assert.equal(status, 0, `${mesh}: ${stderr}`);
      assert.equal(JSON.parse(bytesOf('many.json')).threads, number);
      assert.equal(differenceOfFiles(plain, bytesOf('many.json')), null, `${mesh}, ${number} threads`);
    }
  }
});

test('there are as many threads as processors, or as are asked for', async () => {
  const { processors } = await import(join(installed, 'node_threads.js'));
  const mesh = await htl.generate('torus', { faces: 500 });
  assert.equal((await htl.loops(mesh)).threads, processors);
  assert.equal((await htl.loops(mesh, { threads: 3 })).threads, 3);
  assert.match(new TextDecoder().decode((await htl.run(['--version'])).output), /with threads/);
});

// How many threads more a process has at most while it does something, and how many when that is over: in a process
// that has to end by itself.
function countThreads(action) {
  const text = `
    import { readdirSync } from 'node:fs';
    import { setTimeout as sleep } from 'node:timers/promises';
    import * as htl from ${JSON.stringify(join(installed, 'node.js'))};
    const count = () => readdirSync('/proc/self/task').length;
    const mesh = await htl.generate('gyroid', { faces: 60000 });
    await sleep(500);
    const before = count();
    let most = 0;
    const timer = setInterval(() => { most = Math.max(most, count() - before); }, 5);
    ${action}
    clearInterval(timer);
    for (let i = 0; i < 100 && count() > before; ++i)
      await sleep(50);
    console.log(JSON.stringify({ most, left: count() - before }));
  `;
  const file = join(home, 'counting.js');
  writeFileSync(file, text);
  const { status, stdout, stderr } = spawnSync('node', [file], { timeout: 60000 });
  assert.equal(status, 0, stderr.toString().slice(0, 500));
  return JSON.parse(stdout);
}

test('they work, and end with the run', () => {
  const one = countThreads('await htl.loops(mesh, { threads: 1 });');
  const four = countThreads('await htl.loops(mesh, { threads: 4 });');
  assert.ok(four.most >= one.most + 3, JSON.stringify([one, four]));
  assert.ok(one.left <= 0 && four.left <= 0, JSON.stringify([one, four]));
});

test('a signal ends them', () => {
  const { left } = countThreads(`
    const controller = new AbortController();
    await htl.loops(mesh, {
      threads: 4, signal: controller.signal,
      onProgress: () => { if (count() > before + 3) controller.abort(); },
    }).then(() => { throw new Error('it was not ended'); },
            error => { if (error.name !== 'AbortError') throw error; });
  `);
  assert.ok(left <= 0, `${left} are left`);
});

test('many calls at once', async () => {
  const mesh = await htl.generate('multi-torus', { genus: 3, faces: 4000 });
  const [first, ...others] = await Promise.all(Array.from({ length: 8 }, () => htl.loops(mesh)));
  for (const answer of others)
    assert.deepEqual(answer.pairs, first.pairs);
});

test('what is thrown in several threads at once, each catches', () => {
  const torus = native('generate', 'torus', '--faces', '500', '-o', '-', '-q');
  mkdirSync(join(folder, 'bad'));
  for (let i = 0; i < 40; ++i)
    writeFileSync(join(folder, 'bad', `${i}.off`), i % 4 ? 'OFF\n3 1 0\n' : torus);
  const { status } = command('loops', 'bad', '--csv', 'web.csv', '-q', '--jobs', '4');
  assert.equal(status, nativeRun('loops', 'bad', '--csv', 'native.csv', '-q').exitCode);
  assert.equal(bytesOf('web.csv').toString(), bytesOf('native.csv').toString());
});
