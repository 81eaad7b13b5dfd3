// What a client needs of a worker, in a browser.
export const portOf = worker => ({
  post: message => worker.postMessage(message),
  terminate: () => worker.terminate(),
  onMessage: listener => worker.addEventListener('message', event => listener(event.data)),
  onError: listener => worker.addEventListener('error', listener),
});
