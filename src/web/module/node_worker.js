import { parentPort } from 'node:worker_threads';

import create from './htloops_threads.js';
import { threads } from './node_threads.js';
import { serve } from './worker.js';

serve({ create, threads }, (message, moved) => parentPort.postMessage(message, moved),
      listener => parentPort.on('message', listener));
