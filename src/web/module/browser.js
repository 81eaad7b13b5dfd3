// The package in a browser, by itself or through a bundler.

import { makeAnswers } from './answers.js';
import { portOf } from './browser_port.js';
import { makeClient, HtloopsError } from './client.js';

async function load() {
  const response = await fetch(new URL('./htloops.wasm', import.meta.url));
  if (!response.ok)
    throw new HtloopsError(`htloops.wasm cannot be loaded: ${response.status} ${response.statusText}`, null);
  return WebAssembly.compile(await response.arrayBuffer());
}

const startWorker = () =>
  portOf(new Worker(new URL('./browser_worker.js', import.meta.url), { type: 'module' }));

export const { run, loops, measure, reebGraph, skeleton, removeHandles, clean, cut, generate } =
  makeAnswers(makeClient(load, startWorker));
export { HtloopsError };
