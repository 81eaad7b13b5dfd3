// Runs of htloops in workers: one for each, ended with it. `startWorker()` makes one, `load()` the code.

export class HtloopsError extends Error {
  constructor(message, exitCode, messages = '') {
    super(message);
    this.name = 'HtloopsError';
    this.exitCode = exitCode; // of the tool; null if it broke off
    this.messages = messages;
  }
}

// What the tool said last, without its name.
function reasonIn(messages, exitCode) {
  const begin = messages.lastIndexOf('htloops: ');
  return begin < 0 ? `htloops ended with ${exitCode}` : messages.slice(begin + 9).trim();
}

export function makeClient(load, startWorker) {
  let code = null;

  // The exit code, the outputs by name, the standard output and the messages of one run. A signal ends it at
  // once, wherever it is.
  function run(args, { files = {}, outputs = [], input, signal, onProgress, onText } = {}) {
    return new Promise((resolve, reject) => {
      if (signal?.aborted)
        return reject(signal.reason);
      const worker = startWorker();
      const finish = (settle, value) => {
        signal?.removeEventListener('abort', stop);
        worker.terminate();
        settle(value);
      };
      const stop = () => finish(reject, signal.reason);
      signal?.addEventListener('abort', stop);
      worker.onMessage(message => {
        if ('progress' in message)
          onProgress?.(message.progress, message.what);
        else if ('text' in message)
          onText?.(message.text);
        else if ('failure' in message)
          finish(reject, new HtloopsError(message.failure, null));
        else
          finish(resolve, message);
      });
      worker.onError(error => finish(reject, new HtloopsError(error.message, null)));
      code ??= load().catch(error => {
        code = null; // the next call tries again
        throw error;
      });
      code.then(module => worker.post({ code: module, args, files, outputs, input }),
                error => finish(reject, error));
    });
  }

  // The same for who wants nothing but the outputs: where one is missing, what the tool said is thrown.
  async function outputsOf(args, options) {
    const { exitCode, files, messages } = await run(args, options);
    if (!options.outputs.every(name => name in files))
      throw new HtloopsError(reasonIn(messages, exitCode), exitCode, messages);
    return files;
  }

  return { run, outputsOf };
}
