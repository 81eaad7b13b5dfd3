// One run of htloops: an instance of the module of its own. What a run leaves behind, and a memory that was too
// small, are gone with it. Compiled code is shared by all runs.

// Standard input, output and error of a run, in place of those of the module, which take letters one by one.
// `read(bytes)` fills an array and says how much of it, `write(stream, bytes)` takes one; `terminals` are the
// streams that are shown to a person.
const names = ['/dev/stdin', '/dev/stdout', '/dev/stderr'];

function openStreams(fs, { read, write, terminals }) {
  [0, 1, 2].forEach(stream => fs.close(fs.getStream(stream)));
  [0, 1, 2].forEach(stream => {
    const device = fs.makedev(64, stream), path = `/dev/htloops${stream}`;
    fs.registerDevice(device, {
      open(file) { file.seekable = false; },
      read: (file, heap, offset, length) => read(heap.subarray(offset, offset + length)),
      write(file, heap, offset, length) {
        write(stream, heap.slice(offset, offset + length));
        return length;
      },
    });
    fs.mkdev(path, 0o666, device);
    fs.open(path, stream ? 1 : 0).tty = terminals.includes(stream);
    fs.unlink(names[stream]);
    fs.symlink(path, names[stream]);
  });
}

// How the run ended: its exit code, and its files.
// `create` makes an instance (it is what emscripten wrote), `code` is a WebAssembly.Module;
// `prepare(fs)` puts files where the run finds them; `threads` are `{Worker, processors}`, of a module that has some:
// what makes a worker that is one, and how many are of use.
export async function runTool({ create, code, threads, args, streams, prepare, environment }) {
  let end;
  const exitCode = new Promise(resolve => { end = resolve; });
  const instance = await create({
    ...threads,
    onExit: end,
    instantiateWasm(imports, receive) {
      WebAssembly.instantiate(code, imports).then(made => receive(made, code));
      return {};
    },
    thisProgram: 'htloops',
    preRun: [module => Object.assign(module.ENV, environment)],
    print: text => streams.write(1, new TextEncoder().encode(`${text}\n`)),
    printErr: text => streams.write(2, new TextEncoder().encode(`${text}\n`)),
  });
  openStreams(instance.FS, streams);
  prepare(instance.FS);
  instance.callMain(args); // which with threads returns at once
  return { exitCode: await exitCode, fs: instance.FS };
}
