import { parentPort } from 'node:worker_threads';

import create from './htloops_threads.js';
import { processors } from './node_threads.js';
import { serveThread } from './thread.js';

serveThread(create, message => parentPort.postMessage(message), listener => parentPort.on('message', listener),
            processors);
