// The tasks of the page: the command of each, the files that it writes, and those that can be saved.

// Small files are written with every run; the others when the user saves them.
const asFile = (label, file, option) => ({ label, file, option });

const lines = asFile('lines (OBJ)', 'lines.obj', '--lines');
const model = asFile('model (GLB)', 'model.glb', '--gltf');
const picture = asFile('picture (PNG)', 'picture.png', '--picture');
const table = asFile('table (CSV)', 'table.csv', '--csv');
const report = asFile('report (JSON)', 'report.json', '--report');
const mesh = ending => asFile(`mesh (${ending.toUpperCase()})`, `mesh.${ending}`, '-o');

export const page = asFile('this page (HTML)', 'page.html', '--html');

const pairSetting = { name: 'chosen', label: 'Remove chosen', option: '--pairs' };

export const tasks = {
  loops: {
    label: 'Loops', command: 'loops',
    written: [asFile('loops (JSON)', 'loops.json', '-o'), table, lines], more: [model, picture],
  },
  measure: {
    label: 'Measures', command: 'loops', fixed: ['--measure'],
    written: [asFile('loops with measures (JSON)', 'measures.json', '-o'), table], more: [model, picture],
  },
  reeb: {
    label: 'Reeb graph', command: 'reeb',
    written: [asFile('graph (JSON)', 'graph.json', '-o'), table, lines], more: [model, picture],
  },
  skeleton: {
    label: 'Skeleton', command: 'skeleton',
    written: [asFile('skeleton (JSON)', 'skeleton.json', '-o'), table, lines,
              asFile('skeleton (SWC)', 'skeleton.swc', '--swc')], more: [model, picture],
  },
  remove: {
    label: 'Remove handles', command: 'remove', makesMesh: true,
    written: [mesh('stl'), report, table], more: [mesh('obj'), mesh('ply'), mesh('glb'), mesh('off')],
    ways: [
      pairSetting,
      { name: 'noise', label: 'noise below', option: '--noise-below', value: '1%' },
      { name: 'genus', label: 'smallest, down to genus', option: '--genus', value: '0' },
    ],
  },
  clean: {
    label: 'Clean', command: 'clean', makesMesh: true, takesAll: true,
    written: [{ ...mesh('stl'), option: '' }, report],
    more: ['obj', 'ply', 'glb', '3mf'].map(ending => ({ ...mesh(ending), option: '' })),
  },
  cut: {
    label: 'Cut open', command: 'cut', makesMesh: true,
    written: [mesh('obj'), lines], more: [mesh('ply'), mesh('off'), picture,
      asFile('seams for Blender (Python)', 'seams.py', '--seams')],
  },
};

export const samples = [
  ['Two tori, joined', ['multi-torus', '--genus', '2', '--faces', '20000']],
  ['A plate with bores', ['bores', '--faces', '20000']],
  ['A scan with noise', ['scan', '--faces', '40000']],
  ['A gyroid', ['gyroid', '--faces', '60000']],
  ['A lattice', ['lattice', '--faces', '30000']],
  ['A knotted tube', ['trefoil', '--faces', '20000']],
];

// The name of a saved file. A run writes it under this name, because titles and copied commands contain it.
export const placeOf = (stem, file) => `${stem}-${file}`;

// The command line that writes these files. `remedies` are options that make a mesh acceptable.
export function commandLine(task, meshName, stem, files, { settings, remedies }) {
  return [
    task.command, meshName, ...files.flatMap(({ option, file }) => [option, placeOf(stem, file)].filter(word => word !== '')),
    ...(task.fixed ?? []), ...settings, ...(task.takesAll ? [] : remedies),
  ];
}

// The options that a message of the tool proposes.
export function remediesIn(message) {
  return ['--triangulate', '--repair'].filter(option => message.includes(option));
}
