import create from 'htloops';
import { serve } from '../module/worker.js';

serve(create, (message, moved) => self.postMessage(message, moved),
      listener => self.addEventListener('message', event => listener(event.data)));
