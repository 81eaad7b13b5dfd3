// The package in node.

import { readFile } from 'node:fs/promises';
import { Worker } from 'node:worker_threads';

import { makeAnswers } from './answers.js';
import { makeClient, HtloopsError } from './client.js';

const load = async () => WebAssembly.compile(await readFile(new URL('./htloops_threads.wasm', import.meta.url)));

function startWorker() {
  const worker = new Worker(new URL('./node_worker.js', import.meta.url));
  return {
    post: message => worker.postMessage(message),
    terminate: () => worker.terminate(),
    onMessage: listener => worker.on('message', listener),
    onError: listener => worker.on('error', listener),
  };
}

export const { run, loops, measure, reebGraph, skeleton, removeHandles, clean, cut, generate } =
  makeAnswers(makeClient(load, startWorker));
export { HtloopsError };
