import create from './htloops.js';
import { serve } from './worker.js';

serve({ create }, (message, moved) => self.postMessage(message, moved),
      listener => self.addEventListener('message', event => listener(event.data)));
