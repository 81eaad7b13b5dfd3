#!/usr/bin/env node
// htloops as a command: in this process, on the files of this machine.

import * as node from 'node:fs';
import { isatty } from 'node:tty';

import create from './htloops_threads.js';
import { attemptIn, hostFiles } from './host_files.js';
import { threads } from './node_threads.js';
import { runTool } from './tool.js';

const isWindows = process.platform === 'win32';

// A name as the module has it: the drives of Windows are folders in its root.
const nameOf = word => !isWindows ? word
  : word.replaceAll('\\', '/').replace(/^([A-Za-z]):(?=\/|$)/, (_, letter) => `/${letter.toLowerCase()}:`);

function drives() {
  return [...'abcdefghijklmnopqrstuvwxyz'].filter(letter => node.existsSync(`${letter}:/`))
    .map(letter => [`/${letter}:`, `${letter}:/`]);
}

// The folders in the root but for those that the module has itself.
function folders() {
  return node.readdirSync('/').filter(name => !['dev', 'proc', 'sys'].includes(name))
    .filter(name => node.statSync(`/${name}`, { throwIfNoEntry: false })?.isDirectory())
    .map(name => [`/${name}`, `/${name}`]);
}

// What shells name files in that are none on a disk.
const devices = () => ['/dev/shm', '/dev/fd'].filter(place => node.existsSync(place)).map(place => [place, place]);

let attempt; // in the module that runs

function mountAll(fs) {
  attempt = attemptIn(fs);
  const host = hostFiles(fs, node, nameOf);
  for (const [place, root] of isWindows ? drives() : [...folders(), ...devices()]) {
    if (!fs.analyzePath(place).exists)
      fs.mkdir(place);
    try {
      fs.mount(host, { root, areOpenFiles: place === '/dev/fd' }, place);
    } catch { // a folder that nobody may read is not there
    }
  }
  // What was written here would be in the memory of the module, and lost.
  for (const place of ['/', '/dev'])
    fs.chmod(place, 0o555);
  try {
    fs.chdir(nameOf(process.cwd()));
  } catch { // a folder that is gone has no files, and neither has the root; threads of node want one that is there
    process.chdir('/');
  }
}

// Whoever reads or writes slowly is waited for.
function patiently(action) {
  for (;;)
    try {
      return action();
    } catch (error) {
      if (error.code !== 'EAGAIN')
        throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 5);
    }
}

const streams = {
  terminals: [0, 1, 2].filter(isatty),
  read(bytes) {
    try {
      return patiently(() => node.readSync(0, bytes));
    } catch (error) {
      if (error.code === 'EOF') // of Windows
        return 0;
      throw error;
    }
  },
  write(stream, bytes) {
    try {
      for (let at = 0; at < bytes.length;)
        at += patiently(() => node.writeSync(stream, bytes, at));
    } catch (error) {
      if (error.code === 'EPIPE')
        process.exit(141); // who read has enough
      attempt(() => { throw error; });
    }
  },
};

const code = await WebAssembly.compile(node.readFileSync(new URL('./htloops_threads.wasm', import.meta.url)));
const { exitCode } = await runTool({
  create, code, threads, streams, prepare: mountAll,
  args: process.argv.slice(2).map(nameOf),
  environment: { ...process.env },
});
process.exitCode = exitCode;
