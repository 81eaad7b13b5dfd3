// The npm package as it is packed, in node: installed into an empty folder, asked for all that it has, and compared
// with the native tool.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, lstatSync, mkdirSync, openSync, readFileSync, readdirSync, statSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';

import { installInto, packed } from './installed.mjs';
import { bytesOf, differenceOfFiles, folder, makeMeshes, native, nativeRun } from './meshes.mjs';

const home = join(folder, 'empty');
const compiler = join(process.env.HTL_NODE_MODULES, 'typescript/bin/tsc');
let htl, meshes;

const command = (...args) =>
  spawnSync(join(home, 'node_modules/.bin/htloops'), args, { cwd: folder, maxBuffer: 1 << 28 });

before(async () => {
  htl = await import(join(installInto(home), 'node.js'));
  meshes = makeMeshes();
});

test('what is packed', () => {
  const installed = join(home, 'node_modules/handle-tunnel-loops');
  const names = readdirSync(installed);
  for (const name of ['LICENSE', 'NOTICES', 'README.md', 'index.d.ts', 'htloops.wasm', 'htloops_threads.wasm', 'command.js'])
    assert.ok(names.includes(name), name);
  const { dependencies, version } = JSON.parse(readFileSync(join(installed, 'package.json')));
  assert.equal(dependencies, undefined);
  assert.ok(native('--version').toString().includes(version));
  assert.ok(statSync(packed).size < 4.5e6);
});

test('the command gives the numbers of the native tool, to the last bit', () => {
  for (const mesh of meshes) {
    const { status, stderr } = command('loops', mesh, '-q', '-o', 'web.json', '--csv', 'web.csv', '--lines', 'web.obj');
    assert.equal(status, 0, `${mesh}: ${stderr}`);
    native('loops', mesh, '-q', '-o', 'native.json', '--csv', 'native.csv', '--lines', 'native.obj');
    assert.equal(differenceOfFiles(bytesOf('web.json'), bytesOf('native.json')), null, mesh);
    assert.ok(bytesOf('web.obj').equals(bytesOf('native.obj')), mesh);
    assert.equal(nativeRun('check', mesh, 'web.json').exitCode, 0);
  }
});

test('other commands write the same files', () => {
  const runs = [
    ['remove', 'multi-torus.stl', '--genus', '1', '-q', '-o', 'out.off'],
    ['clean', 'bores.off', 'out.off', '-q'],
    ['cut', 'gyroid.ply', '-q', '-o', 'out.obj'],
    ['skeleton', 'mug.ply', '-q', '--swc', 'out.swc'],
    ['reeb', 'chair.obj', '-q', '--lines', 'out.obj'],
    ['loops', 'cage.off', '-q', '--gltf', 'out.glb'],
    ['repair', 'coral.stl', '-q', '-o', 'out.ply'],
    ['generate', 'scan', '--faces', '40000', '-q', '-o', 'out.off'],
  ];
  for (const run of runs) {
    const file = run.find(word => word.startsWith('out.'));
    assert.equal(command(...run).status, 0, run.join(' '));
    const ours = bytesOf(file);
    native(...run);
    assert.ok(ours.equals(bytesOf(file)), run.join(' '));
  }
});

test('pictures are drawn', () => {
  assert.equal(command('loops', 'torus.off', '-q', '--picture', 'web.png').status, 0);
  native('loops', 'torus.off', '-q', '--picture', 'native.png', '--threads', '1');
  assert.ok(bytesOf('web.png').equals(bytesOf('native.png')));
});

test('pipes, folders and exit codes are as they are natively', () => {
  assert.equal(command('loops', 'nothing.off').status, 3);
  assert.equal(command('loops').status, 2);
  const quads = 'quads.obj';
  writeFileSync(join(folder, quads), 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n');
  const ours = command('loops', quads), theirs = nativeRun('loops', quads);
  assert.deepEqual([ours.status, ours.stderr.toString()], [theirs.exitCode, theirs.messages]);
  const piped = spawnSync(join(home, 'node_modules/.bin/htloops'), ['loops', '-', '--format', 'off', '-qo', '-'],
                          { cwd: folder, input: bytesOf('torus.off') });
  assert.equal(differenceOfFiles(piped.stdout, native('loops', '-q', 'torus.off', '-o', '-')), null);
  assert.ok(!ours.stderr.toString().includes('\x1b'), 'no colours in a pipe');
  mkdirSync(join(folder, 'many'));
  for (const name of ['torus.off', 'lattice.obj'])
    writeFileSync(join(folder, 'many', name), bytesOf(name));
  assert.equal(command('measure', 'many', '--csv', 'many.csv', '-q', '--jobs', '2').status, 0);
  assert.equal(bytesOf('many.csv').toString().trim().split('\n').length, 1 + 1 + 12);
});

test('pipes have names', { skip: process.platform === 'win32' }, () => {
  const htloops = join(home, 'node_modules/.bin/htloops');
  const shell = line => execFileSync('bash', ['-ec', line], { cwd: folder, maxBuffer: 1 << 28 });
  const expected = native('loops', '-q', 'torus.off', '-o', '-');
  execFileSync('mkfifo', ['in.off', 'out.json'], { cwd: folder });
  for (const line of [`cat torus.off >in.off & '${htloops}' loops in.off -qo -`,
                      `'${htloops}' loops <(cat torus.off) --format off -qo -`,
                      `cat out.json & '${htloops}' loops torus.off -qo out.json; wait`])
    assert.equal(differenceOfFiles(shell(line), expected), null, line);
});

test('links are written through, and stay', () => {
  writeFileSync(join(folder, 'target.json'), '');
  for (const [target, link] of [['target.json', 'there.json'], ['made.json', 'nowhere.json'], ['round.json', 'round.json']])
    symlinkSync(target, join(folder, link));
  for (const [link, target] of [['there.json', 'target.json'], ['nowhere.json', 'made.json']]) {
    assert.equal(command('loops', 'torus.off', '-qo', link).status, 0);
    assert.ok(lstatSync(join(folder, link)).isSymbolicLink(), link);
    assert.ok(bytesOf(target).length > 1000, target);
  }
  const ours = command('loops', 'torus.off', '-qo', 'round.json'), theirs = nativeRun('loops', 'torus.off', '-qo', 'round.json');
  assert.deepEqual([ours.status, ours.stderr.toString()], [theirs.exitCode, theirs.messages]);
});

test('what cannot be kept is said', { skip: !existsSync('/dev/full') }, () => {
  for (const file of ['/dev/full', '/dev/nothing.json']) {
    const { status, stderr } = command('loops', 'torus.off', '-qo', file);
    assert.equal(status, 2, file);
    assert.ok(stderr.toString().includes(`cannot write ${file}`));
  }
  const options = { cwd: folder, stdio: ['ignore', openSync('/dev/full', 'w'), 'pipe'] };
  const { status, stderr } = spawnSync(join(home, 'node_modules/.bin/htloops'), ['loops', 'torus.off'], options);
  assert.equal(status, 2);
  assert.match(stderr.toString(), /^htloops: cannot write the standard output: No space left on device\n$/);
});

test('a folder that is gone is no reason to break off', { skip: process.platform === 'win32' }, () => {
  const { status, stdout } = spawnSync('sh', ['-c', 'mkdir gone && cd gone && rmdir ../gone && exec "$0" --version',
                                              join(home, 'node_modules/.bin/htloops')], { cwd: folder });
  assert.equal(status, 0);
  assert.ok(stdout.toString().includes('htloops'));
});

test('the lines of the README', () => {
  const readme = readFileSync(join(home, 'node_modules/handle-tunnel-loops/README.md'), 'utf8');
  const lines = [...readme.matchAll(/^ {4}npx (.*?)(?: *#.*)?$/gm)].map(([, words]) => words.split(' '));
  assert.ok(lines.length >= 4);
  native('generate', 'mug', '--faces', '20000', '-q', '-o', join(home, 'mesh.stl'));
  native('generate', 'mug', '--faces', '20000', '-q', '-o', join(home, 'scan.ply'));
  for (const words of lines)
    execFileSync('npx', ['--offline', ...words], { cwd: home, stdio: 'pipe' });
  for (const file of ['loops.html', 'solid.stl'])
    assert.ok(statSync(join(home, file)).size > 1000, file);
  writeFileSync(join(home, 'readme.js'), /```js\n(.*?)```/s.exec(readme)[1]);
  const words = execFileSync('node', ['readme.js'], { cwd: home }).toString().trim().split('\n');
  assert.equal(words.length, 4); // three pairs, and what is left
  assert.match(words[3], /^1 \d+$/);
});

test('the types are those of the functions', { skip: !existsSync(compiler) }, () => {
  writeFileSync(join(home, 'typed.ts'), `
    import { loops, measure, reebGraph, skeleton, removeHandles, clean, cut, generate, run, HtloopsError } from 'handle-tunnel-loops';
    const mesh = await generate('torus', { faces: 500 });
    const { pairs } = await loops(mesh, { basis: 'shortest', onProgress: (part: number, what: string) => {} });
    const points: Float64Array = pairs[0].handle.points, triangles: Uint32Array = (await removeHandles(mesh, { genus: 0 })).mesh.triangles;
    const { exitCode } = await run(['--version'], { signal: AbortSignal.timeout(1000) });
    // @ts-expect-error
    await removeHandles(mesh);
    export { points, triangles, exitCode, measure, reebGraph, skeleton, clean, cut, HtloopsError };
  `);
  execFileSync('node', [compiler, '--noEmit', '--strict', '--target', 'esnext', '--module', 'nodenext', 'typed.ts'],
               { cwd: home, stdio: 'pipe' });
  const declared = readFileSync(join(home, 'node_modules/handle-tunnel-loops/index.d.ts'), 'utf8');
  const names = [...declared.matchAll(/export (?:function|class) (\w+)/g)].map(([, name]) => name).sort();
  assert.deepEqual(names, Object.keys(htl).sort());
});

test('arrays in, arrays out', async () => {
  const mesh = await htl.generate('multi-torus', { genus: 3, faces: 3000 });
  assert.ok(mesh.points instanceof Float64Array && mesh.triangles instanceof Uint32Array);
  const steps = [];
  const { pairs, certificate } = await htl.loops(mesh, { onProgress: part => steps.push(part) });
  assert.equal(pairs.length, 3);
  assert.ok(certificate.basis && certificate.closed_on_surface);
  for (const { handle, tunnel } of pairs)
    for (const loop of [handle, tunnel]) {
      assert.ok(loop.points instanceof Float64Array);
      const count = loop.points.length / 3, at = i => loop.points.subarray(3 * (i % count), 3 * (i % count) + 3);
      let length = 0;
      for (let i = 0; i < count; ++i)
        length += Math.hypot(...at(i + 1).map((x, k) => x - at(i)[k]));
      assert.ok(Math.abs(length - loop.length) < 1e-12 * length);
    }
  const { mesh: ball, report } = await htl.removeHandles(mesh, { all: true });
  assert.equal(report.genus_after, 0);
  assert.equal(new Set(ball.triangles).size - ball.triangles.length / 3 / 2, 2); // V - E + F of a sphere
  assert.ok((await htl.measure(mesh)).pairs.every(({ thickness }) => thickness.diameter > 0));
  assert.equal((await htl.reebGraph(mesh)).cycles, 3);
  assert.ok((await htl.skeleton(mesh)).certificate.inside);
  assert.equal((await htl.clean(mesh)).report.after.boundaries, 0);
  const { mesh: disk } = await htl.cut(mesh);
  assert.ok(disk.points.length > mesh.points.length);
});

test('errors are those of the tool, and a signal ends a run', async () => {
  const open = { points: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], triangles: [0, 1, 2, 0, 1, 3, 0, 1, 2] };
  await assert.rejects(htl.loops(open), error => error.exitCode === 4 && error.message.includes('--repair'));
  await assert.rejects(htl.loops({ points: [0, 1], triangles: [] }), TypeError);
  await assert.rejects(htl.loops(open, { noSuchOption: true }), error => error.exitCode === 2);
  assert.deepEqual((await htl.run(['--version'], { outputs: ['..', '', 'none/x'] })).files, {}, 'folders are no outputs');
  const began = performance.now();
  await assert.rejects(htl.run(['generate', 'gyroid', '--faces', '3000000', '-o', 'x.off'],
                               { signal: AbortSignal.timeout(300) }), { name: 'TimeoutError' });
  assert.ok(performance.now() - began < 1500);
});

test('arrays that are none of a mesh are refused', async () => {
  const mesh = await htl.generate('torus', { faces: 500 });
  for (const wrong of [-1, 0.5, NaN, 2 ** 32, '0']) {
    const triangles = Array.from(mesh.triangles);
    triangles[4] = wrong;
    await assert.rejects(htl.loops({ ...mesh, triangles }), { name: 'TypeError', message: /^triangles: .*, at 4,/ }, `${wrong}`);
  }
  for (const none of [null, {}, { points: 'abc', triangles: 'abc' }, { points: {}, triangles: {} }])
    await assert.rejects(htl.loops(none), { name: 'TypeError', message: /^points: an array/ });
});

test('a signal ends the making of a mesh, too', async () => {
  await assert.rejects(htl.generate('gyroid', { faces: 3000000, signal: AbortSignal.timeout(300) }), { name: 'TimeoutError' });
});

test('code that could not be loaded once is loaded by the next call', async () => {
  const { makeClient } = await import(join(home, 'node_modules/handle-tunnel-loops/client.js'));
  let loads = 0, listener;
  const load = async () => {
    if (++loads === 1)
      throw new Error('no code');
    return 'code';
  };
  const startWorker = () => ({
    post: ({ code }) => listener({ exitCode: 0, code }), terminate() {}, onError() {},
    onMessage(listening) { listener = listening; },
  });
  const { run } = makeClient(load, startWorker);
  await assert.rejects(run([]), /no code/);
  assert.equal((await run([])).code, 'code');
});

test('no memory is said, and the next call is answered', async () => {
  const { exitCode, messages } = await htl.run(['generate', 'torus', '--faces', '600000000', '-o', 'x.off', '-q']);
  assert.notEqual(exitCode, 0);
  assert.match(messages, /memory/);
  assert.equal((await htl.run(['--version'])).exitCode, 0);
});
