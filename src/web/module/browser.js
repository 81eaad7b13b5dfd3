// The package in a browser, by itself or through a bundler.

import { makeAnswers } from './answers.js';
import { portOf } from './browser_port.js';
import { makeClient, HtloopsError } from './client.js';

// Threads share memory, which a page may only where no other can look into it.
const hasThreads = globalThis.crossOriginIsolated === true;

async function load() {
  const address = hasThreads ? new URL('./htloops_threads.wasm', import.meta.url)
    : new URL('./htloops.wasm', import.meta.url);
  const response = await fetch(address);
  if (!response.ok)
    throw new HtloopsError(`${address} cannot be loaded: ${response.status} ${response.statusText}`, null);
  return WebAssembly.compile(await response.arrayBuffer());
}

// Each in the words that bundlers look for.
const startWorker = () => portOf(hasThreads
  ? new Worker(new URL('./browser_threads_worker.js', import.meta.url), { type: 'module' })
  : new Worker(new URL('./browser_worker.js', import.meta.url), { type: 'module' }));

export const { run, loops, measure, reebGraph, skeleton, removeHandles, clean, cut, generate } =
  makeAnswers(makeClient(load, startWorker));
export { HtloopsError };
