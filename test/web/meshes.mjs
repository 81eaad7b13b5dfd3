// Meshes that the tests are made with, and the native tool.

import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export const tool = process.env.HTLOOPS;
export const folder = mkdtempSync(join(tmpdir(), 'htloops-web-'));

// Kinds of meshes, those of any genus with one.
const kinds = [
  ['torus'], ['multi-torus', 3], ['gyroid', 5], ['lattice', 12], ['bores'], ['trefoil'], ['mug'], ['chair'],
  ['cage'], ['coral'], ['bicycle'], ['borromean'], ['exchanger'], ['chain', 4], ['torus-link', 2], ['foam', 6],
  ['interlaced', 4], ['hubs', 5], ['plates', 4], ['random', 3],
];

export const native = (...args) => execFileSync(tool, args, { cwd: folder });

// What a run says, whatever it ends with.
export function nativeRun(...args) {
  const { status, stdout, stderr } = spawnSync(tool, args, { cwd: folder });
  return { exitCode: status, output: stdout.toString(), messages: stderr.toString() };
}

// A mesh of each kind, or of the first ones, of some thousand faces, as a file.
export function makeMeshes(number = kinds.length) {
  return kinds.slice(0, number).map(([kind, genus], i) => {
    const file = `${kind}.${['off', 'stl', 'ply', 'obj'][i % 4]}`;
    native('generate', kind, '--faces', genus ? '8000' : '45000', ...(genus ? ['--genus', String(genus)] : []),
           '-q', '-o', file);
    return file;
  });
}

export const bytesOf = file => readFileSync(join(folder, file));

// What differs from run to run, and from machine to machine, and nothing else.
const ownOfRun = new Set(['.tool', '.timings', '.threads', '.fallback', '.mesh.file']);

// Where two answers differ first; null if they are the same to the last bit.
export function difference(left, right, path = '') {
  if (ownOfRun.has(path))
    return null;
  if (left === null || right === null || typeof left !== 'object' || typeof right !== 'object')
    return Object.is(left, right) ? null : `${path}: ${left}, ${right}`;
  for (const key of new Set([...Object.keys(left), ...Object.keys(right)])) {
    const found = difference(left[key], right[key], `${path}.${key}`);
    if (found !== null)
      return found;
  }
  return null;
}

export const differenceOfFiles = (left, right) => difference(JSON.parse(left), JSON.parse(right));
