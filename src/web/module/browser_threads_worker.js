// The same with threads, which are workers of this very script, under another name.

import create from './htloops_threads.js';
import { serveThread } from './thread.js';
import { serve } from './worker.js';

const name = 'htloops thread', processors = navigator.hardwareConcurrency;

function Thread() {
  return new Worker(self.location.href, { type: 'module', name });
}

const onMessage = listener => self.addEventListener('message', event => listener(event.data));

if (self.name === name)
  serveThread(create, message => self.postMessage(message), onMessage, processors);
else
  serve({ create, threads: { Worker: Thread, processors } },
        (message, moved) => self.postMessage(message, moved), onMessage);
