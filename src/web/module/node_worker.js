import { parentPort } from 'node:worker_threads';

import create from './htloops.js';
import { serve } from './worker.js';

serve(create, (message, moved) => parentPort.postMessage(message, moved),
      listener => parentPort.on('message', listener));
