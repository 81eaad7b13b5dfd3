// The page that computes: opens a mesh, runs a task, shows the page of its result, and saves files.

import { portOf } from '../module/browser_port.js';
import { makeClient } from '../module/client.js';
import { commandLine, page, placeOf, remediesIn, samples, tasks } from './tasks.js';

const element = id => document.getElementById(id);

function made(tag, properties = {}, ...children) {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
}

// ---- the module, which is inside this page

async function load() {
  const packed = Uint8Array.from(atob(element('module').textContent), letter => letter.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
}

const workerAddress = URL.createObjectURL(new Blob([element('worker').textContent], { type: 'text/javascript' }));

const { run } = makeClient(load, () => portOf(new Worker(workerAddress)));

// ---- files

const meshEnding = /\.(off|obj|ply|stl|glb|gltf|3mf|vtp|vtu|msh2?|gii|surf|pial|white|inflated|orig)(\.gz)?$/i;

// A file name without folders that cannot be taken for an option.
const safeName = name => name.replace(/[/\\\0]/g, '_').slice(-200).replace(/^-/, './-');

// The stem of the names of results: without letters that need quotes, and not an option.
const stemOf = name => name.replace(meshEnding, '').replace(/[^\w.-]+/g, '_').slice(-100).replace(/^[-.]+/, '') || 'mesh';

const bytesOf = async file => new Uint8Array(await file.arrayBuffer());

function download(name, bytes) {
  const link = made('a', { href: URL.createObjectURL(new Blob([bytes])), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const seconds = since => `${((performance.now() - since) / 1000).toFixed(1)} s`;

// The messages of a run, without the name of the tool.
const wordsOf = ({ output, messages }) =>
  (new TextDecoder().decode(output) + messages).replaceAll('htloops: ', '').trimEnd();

// The first line that does not belong to a table.
const summaryIn = words => words.split('\n').find(line => /^\S/.test(line)) ?? '';

// ---- the page

class App {
  mesh = null; // { name, path, files }: the mesh file, and all files opened with it
  task = tasks.loops;
  settings = []; // of the run whose result is shown
  remedies = [];
  results = {};
  chosen = [];
  running = null;
  isBusy = false;
  done = 0; // the number of finished actions, successful or not

  constructor() {
    this.makeTasks();
    this.makeSamples();
    this.makeSave();
    this.listenToFiles();
    element('cancel').onclick = () => this.running?.abort(new Error('Cancelled'));
    element('more').onclick = event => {
      event.preventDefault();
      element('about').showModal();
    };
    window.addEventListener('message', event => {
      if (event.source === element('viewer').contentWindow && Array.isArray(event.data?.chosen))
        this.choose(event.data.chosen);
    });
    this.refresh();
    document.body.classList.add('ready');
  }

  // ---- controls

  makeTasks() {
    for (const [name, task] of Object.entries(tasks).filter(([, { ways }]) => !ways)) {
      const button = made('button', { type: 'button', textContent: task.label, id: `task-${name}` });
      button.onclick = () => this.perform(() => this.compute(task));
      element('tasks').append(button);
      task.button = button;
    }
    const { ways } = tasks.remove;
    for (const way of ways) {
      const button = made('button', { type: 'button', textContent: way.label, id: `remove-${way.name}` });
      const input = way.value ? made('input', { value: way.value, ariaLabel: way.label, id: `remove-${way.name}-value` }) : '';
      button.onclick = () => this.perform(() => this.compute(
        tasks.remove, [way.option, input ? input.value.trim() : this.chosen.join(',')]));
      element('settings').append(button, input);
      way.button = button;
    }
    ways[1].button.before('Remove: ');
  }

  makeSamples() {
    const choice = element('sample');
    choice.append(...samples.map(([label], i) => made('option', { value: i, textContent: label })));
    choice.onchange = () => {
      const sample = samples[Number(choice.value)];
      choice.value = '';
      if (sample)
        this.perform(() => this.generate(...sample));
    };
  }

  makeSave() {
    const choice = element('save');
    choice.onchange = () => {
      const { value } = choice;
      choice.value = '';
      if (value)
        this.perform(() => this.save(value));
    };
  }

  listenToFiles() {
    const main = document.querySelector('main'), input = element('file');
    element('open').onclick = () => input.click();
    const take = files => this.perform(() => this.take([...files]));
    input.onchange = () => {
      const files = [...input.files];
      input.value = ''; // the same file can be opened again
      take(files);
    };
    for (const name of ['dragenter', 'dragover', 'dragleave', 'drop'])
      document.addEventListener(name, event => {
        event.preventDefault();
        main.classList.toggle('dragged', name === 'dragenter' || name === 'dragover');
      });
    document.addEventListener('drop', event => take(event.dataTransfer.files));
  }

  refresh() {
    const isIdle = this.running === null, { task } = this;
    for (const each of Object.values(tasks))
      if (each.button) {
        each.button.disabled = !isIdle || !this.mesh;
        each.button.ariaPressed = each === task && this.isShown;
      }
    for (const way of tasks.remove.ways)
      way.button.disabled = !isIdle || !this.mesh || way.option === '--pairs' && this.chosen.length === 0;
    element('cancel').hidden = element('progress').hidden = isIdle;
    element('open').disabled = element('sample').disabled = element('save').disabled = !isIdle;
    element('save').hidden = !this.isShown;
    element('name').textContent = this.mesh?.name ?? '';
  }

  choose(numbers) {
    this.chosen = numbers.filter(Number.isInteger);
    this.refresh();
  }

  // ---- messages

  say(text, isError = false) {
    element('message').textContent = text;
    element('message').className = isError ? 'error' : '';
    element('remedies').replaceChildren();
  }

  // A button for each option that a message proposes.
  offer(message, again) {
    const labels = { '--triangulate': 'Triangulate', '--repair': 'Repair' };
    for (const option of remediesIn(message).filter(each => !this.remedies.includes(each))) {
      const button = made('button', { type: 'button', textContent: labels[option] });
      button.onclick = () => {
        this.remedies.push(option);
        this.perform(again);
      };
      element('remedies').append(button);
    }
  }

  // ---- actions

  // One thing at a time.
  async perform(action) {
    if (this.isBusy)
      return;
    this.isBusy = true;
    try {
      await action();
    } catch (error) {
      this.say(error.message, true);
    } finally {
      this.isBusy = false;
      ++this.done;
    }
  }

  async take(files) {
    const mesh = files.find(({ name }) => meshEnding.test(name)) ?? files[0];
    if (!mesh)
      return;
    const all = {};
    for (const file of files)
      all[safeName(file.name)] = await bytesOf(file);
    this.open({ name: mesh.name, path: safeName(mesh.name), files: all });
    await this.compute(tasks.loops);
  }

  open(mesh) {
    this.mesh = mesh;
    this.remedies = [];
    this.isShown = false;
  }

  async generate(label, words) {
    const path = `${words[0]}.off`;
    const args = ['generate', ...words, '-o', path, '-q'];
    const result = await this.run(`Generating: ${label}`, args, { outputs: [path] });
    if (!result)
      return;
    this.open({ name: label, path, files: { [path]: result.files[path] } });
    await this.compute(tasks.loops);
  }

  // One run of the tool, with its progress and its Cancel; null if it was cancelled, or failed.
  async run(label, args, options) {
    this.running = new AbortController();
    this.say(label);
    element('progress').removeAttribute('value');
    this.refresh();
    try {
      return await run(args, {
        ...options, signal: this.running.signal,
        onProgress: (part, what) => {
          element('progress').value = part;
          element('message').textContent = `${label}: ${what}`;
        },
      });
    } catch (error) {
      this.say(this.running.signal.aborted ? 'Cancelled.' : `The computation failed: ${error.message}`,
               !this.running.signal.aborted);
      return null;
    } finally {
      this.running = null;
      this.refresh();
    }
  }

  // A run that writes files of a task, which are returned by name.
  async runTask(label, task, wanted, settings) {
    const { mesh, remedies } = this, stem = stemOf(mesh.name);
    const result = await this.run(label, commandLine(task, mesh.path, stem, wanted, { settings, remedies }),
                                  { files: mesh.files, outputs: wanted.map(({ file }) => placeOf(stem, file)) });
    if (result)
      result.files = Object.fromEntries(wanted.map(({ file }) => [file, result.files[placeOf(stem, file)]]));
    return result;
  }

  async compute(task, settings = []) {
    const began = performance.now();
    const result = await this.runTask(task.label, task, [...task.written, page], settings);
    if (!result)
      return;
    const { exitCode, files } = result, words = wordsOf(result);
    if (!files[page.file]) {
      this.say(words || `There is no result (exit code ${exitCode}).`, true);
      this.offer(words, () => this.compute(task, settings));
      return;
    }
    Object.assign(this, { task, settings, results: files, chosen: [], isShown: true });
    this.show(files[page.file]);
    this.say(`${summaryIn(words)} (${seconds(began)} in total)`);
    this.refresh();
    this.listSaves();
  }

  show(html) {
    element('welcome').hidden = true;
    element('viewer').hidden = false;
    element('viewer').srcdoc = new TextDecoder().decode(html);
  }

  listSaves() {
    const { task } = this;
    element('save').replaceChildren(
      made('option', { value: '', textContent: 'Save\u2026' }),
      ...[...task.written, ...task.more, page]
        .map(({ label, file }) => made('option', { value: file, textContent: label })),
      ...(task.makesMesh ? [made('option', { value: 'go on', textContent: 'continue with the new mesh' })] : []));
  }

  async save(file) {
    const { task } = this;
    if (file === 'go on')
      return this.goOn();
    if (!this.results[file]) {
      const wanted = task.more.find(each => each.file === file);
      const result = await this.runTask(`Writing: ${wanted.label}`, task, [wanted], this.settings);
      if (!result?.files[file]) {
        if (result)
          this.say(wordsOf(result), true);
        return;
      }
      this.results[file] = result.files[file];
      this.say('');
    }
    download(placeOf(stemOf(this.mesh.name), file), this.results[file]);
  }

  goOn() {
    const [{ file }] = this.task.written, bytes = this.results[file];
    const name = placeOf(stemOf(this.mesh.name), file);
    this.open({ name, path: name, files: { [name]: bytes } });
    return this.compute(tasks.loops);
  }
}

// Threads share memory, which browsers allow only on isolated pages: the server must send headers.
if (HAS_THREADS && !crossOriginIsolated)
  document.body.className = 'refused';
else
  window.app = new App();
