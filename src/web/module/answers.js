// The functions of the package: arrays in, arrays out, by a run of the tool.

import { meshOfOff, plyOf } from './meshes.js';

const optionOf = name => `--${name.replace(/[A-Z]/g, letter => `-${letter.toLowerCase()}`)}`;

// `{shorterThan: '3%', quiet: true, pairs: [0, 2]}` as the tool has it.
function argumentsOf(options) {
  return Object.entries(options).flatMap(([name, value]) =>
    value === undefined || value === null || value === false ? []
      : value === true ? [optionOf(name)]
        : [optionOf(name), Array.isArray(value) ? value.join(',') : String(value)]);
}

const jsonOf = bytes => JSON.parse(new TextDecoder().decode(bytes));

// Points as they are in files of JSON, one array each, as one array of numbers.
const flat = points => Float64Array.from(points.flat());

function withArrays(pairs) {
  for (const pair of pairs)
    for (const loop of [pair.handle, pair.tunnel])
      loop.points = flat(loop.points);
  return pairs;
}

export function makeAnswers({ run, outputsOf }) {
  // What a command says of a mesh, as files: `outputs` are their names, by the options that ask for them.
  const ask = (command, mesh, outputs, { signal, onProgress, ...options }) => outputsOf(
    [command, 'mesh.ply', ...Object.entries(outputs).flat().filter(word => word !== ''),
     ...argumentsOf({ ...options, quiet: !onProgress })],
    { files: { 'mesh.ply': plyOf(mesh) }, outputs: Object.values(outputs), signal, onProgress });

  async function loops(mesh, options = {}) {
    const answer = jsonOf((await ask('loops', mesh, { '-o': 'loops.json' }, options))['loops.json']);
    withArrays(answer.pairs);
    return answer;
  }

  const measure = (mesh, options = {}) => loops(mesh, { measure: true, ...options });

  async function reebGraph(mesh, options = {}) {
    const graph = jsonOf((await ask('reeb', mesh, { '-o': 'graph.json' }, options))['graph.json']);
    for (const arc of graph.arcs)
      arc.polyline = flat(arc.polyline);
    return graph;
  }

  const skeleton = async (mesh, options = {}) =>
    jsonOf((await ask('skeleton', mesh, { '-o': 'skeleton.json' }, options))['skeleton.json']);

  // The mesh that a command makes, with its report. What could not be done is told by the report.
  async function changed(command, mesh, option, options) {
    const found = await ask(command, mesh, { [option]: 'changed.off', '--report': 'report.json' }, options);
    return { mesh: meshOfOff(found['changed.off']), report: jsonOf(found['report.json']) };
  }

  const removeHandles = (mesh, options = {}) => changed('remove', mesh, '-o', options);
  const clean = (mesh, options = {}) => changed('clean', mesh, '', options);

  const cut = async (mesh, options = {}) =>
    ({ mesh: meshOfOff((await ask('cut', mesh, { '-o': 'open.off' }, options))['open.off']) });

  async function generate(kind, { signal, ...options } = {}) {
    const files = await outputsOf(
      ['generate', kind, '-o', 'mesh.off', ...argumentsOf({ ...options, quiet: true })],
      { outputs: ['mesh.off'], signal });
    return meshOfOff(files['mesh.off']);
  }

  return { run, loops, measure, reebGraph, skeleton, removeHandles, clean, cut, generate };
}
