// What a worker does: one run, on files in memory. It is told `{code, args, files, outputs, input}` and says
// `{progress, what}` and `{text}` on the way, at last `{exitCode, files, output, messages}` or `{failure}`.

import { runTool } from './tool.js';

const folder = '/files';

// The line that the tool draws for a terminal: `[####....]  40%  0.3 s  what`.
const progressLine = /^\[[#.]*\]\s+(\d+)%\s+[\d.]+ s\s+(.*)$/;

// Tells progress apart from messages: a line that a carriage return begins is drawn over the one before.
class Messages {
  constructor(say) {
    this.say = say;
    this.decoder = new TextDecoder();
    this.rest = '';
    this.text = '';
  }

  add(bytes) {
    const pieces = (this.rest + this.decoder.decode(bytes, { stream: true })).split(/(\r|\n|\x1b\[K)/);
    this.rest = '';
    for (let i = 0; i < pieces.length; i += 2) {
      const [line, end] = [pieces[i], pieces[i + 1]], progress = progressLine.exec(line);
      if (progress && end)
        this.say({ progress: Number(progress[1]) / 100, what: progress[2] });
      else if (end === undefined)
        this.rest = line;
      else if (end === '\n') {
        this.text += `${line}\n`;
        this.say({ text: line });
      }
    }
  }
}

function joined(parts) {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  parts.reduce((at, part) => (whole.set(part, at), at + part.length), 0);
  return whole;
}

function outputsOf(fs, names) {
  const files = {};
  for (const name of names) {
    const { exists, object } = fs.analyzePath(`${folder}/${name}`);
    if (exists && fs.isFile(object.mode))
      files[name] = fs.readFile(`${folder}/${name}`);
  }
  return files;
}

async function answer(tool, { code, args, files = {}, outputs = [], input = new Uint8Array() }, say) {
  const messages = new Messages(say), output = [];
  let at = 0;
  const streams = {
    terminals: [2], // for its progress
    read(bytes) {
      const part = input.subarray(at, at + bytes.length);
      bytes.set(part);
      at += part.length;
      return part.length;
    },
    write: (stream, bytes) => stream === 2 ? messages.add(bytes) : output.push(bytes),
  };
  const { exitCode, fs } = await runTool({
    ...tool, code, args, streams, environment: { NO_COLOR: '1' },
    prepare(system) {
      system.mkdir(folder);
      system.chdir(folder);
      for (const name of [...Object.keys(files), ...outputs])
        system.mkdirTree(`${folder}/${name}`.replace(/\/[^/]*$/, ''));
      for (const [name, bytes] of Object.entries(files))
        system.writeFile(name, bytes, { canOwn: true });
    },
  });
  return { exitCode, files: outputsOf(fs, outputs), output: joined(output), messages: messages.text };
}

// `tool` is what makes an instance, with its threads if it has some (see tool.js); `post(message, transferred)` and
// `onMessage` are those of the worker, in a browser or in node.
export function serve(tool, post, onMessage) {
  onMessage(async task => {
    try {
      const result = await answer(tool, task, message => post(message, []));
      post(result, [...Object.values(result.files), result.output].map(bytes => bytes.buffer));
    } catch (error) {
      post({ failure: `${error.name}: ${error.message}` }, []);
    }
  });
}
