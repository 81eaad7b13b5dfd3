// Threads of a run in node.

import * as system from 'node:os';
import { Worker } from 'node:worker_threads';

export const processors = system.availableParallelism?.() ?? system.cpus().length;

// A worker of node, as one of a browser.
class Thread {
  constructor() {
    this.worker = new Worker(new URL('./node_thread.js', import.meta.url));
    this.worker.on('message', data => this.onmessage({ data }));
    this.worker.on('error', error => this.onerror(error));
  }

  postMessage(message) {
    this.worker.postMessage(message);
  }

  terminate() {
    this.worker.terminate();
  }
}

export const threads = { Worker: Thread, processors };
