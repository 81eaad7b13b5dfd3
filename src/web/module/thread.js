// What a worker does that is a thread of a run: it computes in the memory of that run, in an instance of its own. It
// stands in the place of the file that emscripten writes for this, which finds its code by an address: so it can be in
// one file with all else. The words that are spoken here are those of emscripten.

function start(instance, { start_routine: routine, arg: argument, threadInfoStruct: thread, time }) {
  instance.__performance_now_clock_drift = performance.now() - time; // one clock for all threads
  instance.__emscripten_thread_init(thread, 0, 0, 1); // not the main thread in any way, and it may wait
  instance.establishStackSpace();
  instance.PThread.threadInit();
  try {
    instance.__emscripten_thread_exit(instance.invokeEntryPoint(routine, argument));
  } catch (error) {
    if (error !== 'unwind') { // with this word the thread has ended the run
      instance.__emscripten_thread_crashed();
      throw error;
    }
  }
}

// `post`, `onMessage` and `processors` are those of the worker, in a browser or in node.
export function serveThread(create, post, onMessage, processors) {
  let instance = null;

  const load = ({ wasmMemory, wasmModule }) => create({
    ENVIRONMENT_IS_PTHREAD: true, wasmMemory, buffer: wasmMemory.buffer, postMessage: post, processors,
    instantiateWasm(imports, receive) {
      const made = new WebAssembly.Instance(wasmModule, imports);
      receive(made, wasmModule);
      return made.exports;
    },
  }).then(made => { instance = made; },
          error => setTimeout(() => { throw error; })); // which the run is told then

  onMessage(message => {
    if (message.cmd === 'load')
      load(message);
    else if (message.cmd === 'run')
      start(instance, message);
  });
}
