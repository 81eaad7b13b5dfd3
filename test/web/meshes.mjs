// Meshes that the tests are made with, and the native tool.

import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export const tool = process.env.HTLOOPS;
export const folder = mkdtempSync(join(tmpdir(), 'htloops-web-'));

const kinds = [
  ['torus', 1], ['multi-torus', 3], ['gyroid', 5], ['lattice', 12], ['bores', 20], ['trefoil', 1], ['mug', 1],
  ['chair', 7], ['cage', 36], ['coral', 6], ['bicycle', 14], ['borromean', 3], ['exchanger', 7], ['chain', 4],
  ['torus-link', 2], ['foam', 6], ['interlaced', 4], ['hubs', 5], ['plates', 4], ['random', 3],
];

export const native = (...args) => execFileSync(tool, args, { cwd: folder });

// What a run says, whatever it ends with.
export function nativeRun(...args) {
  const { status, stdout, stderr } = spawnSync(tool, args, { cwd: folder });
  return { exitCode: status, output: stdout.toString(), messages: stderr.toString() };
}

// A mesh of each kind, of some thousand faces, as a file.
export function makeMeshes() {
  return kinds.map(([kind, genus], i) => {
    const file = `${kind}.${['off', 'stl', 'ply', 'obj'][i % 4]}`;
    const genera = ['torus', 'bores', 'trefoil', 'mug', 'chair', 'cage', 'coral', 'bicycle', 'borromean', 'exchanger'];
    native('generate', kind, '--faces', '8000', ...(genera.includes(kind) ? [] : ['--genus', String(genus)]),
           '-q', '-o', file);
    return file;
  });
}

export const bytesOf = file => readFileSync(join(folder, file));

// The answer but for what differs from run to run, and from machine to machine.
export function comparable(json) {
  const answer = JSON.parse(json);
  for (const key of ['tool', 'timings', 'threads', 'fallback', 'backend'])
    delete answer[key];
  answer.mesh.file = '';
  return answer;
}
