// Makes pages of the tool, takes pictures of them in windows of several sizes, light and dark, and puts these on a
// sheet. scripts/make_contact_sheet.sh tells the options.

import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';

import { launch, newPage } from './browsers.mjs';

const tool = process.env.HTLOOPS;
const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

// Kinds that are generated, with the words that make them.
const generated = {
  gyroid: ['--genus', '8', '--faces', '20000'],
  lattice: ['--genus', '12', '--faces', '20000'],
  bores: ['--faces', '20000'],
  mug: ['--faces', '45000'],
  chair: ['--faces', '45000'],
  scan: ['--genus', '3', '--faces', '60000', '--bridges', '9', '--tunnels', '6'],
};
const files = ['happy_buddha_54k', 'fertility_6k', 'engine_Adapted03dist', 'of_flange', 'protein_2jho', 'dancer'];

// What makes a page of each kind.
const kinds = {
  loops: ['loops'],
  removal: ['remove', '--all', '-o', 'removed.off'],
  skeleton: ['skeleton'],
  reeb: ['reeb'],
  measures: ['measure'],
  'dry-run': ['remove', '--genus', '1', '--dry-run'],
  empty: ['loops'],
};
const kindsOfAll = ['loops', 'removal', 'skeleton', 'empty'];

function optionsOf(words) {
  const many = { type: 'string', multiple: true };
  const { values, positionals } = parseArgs({
    args: words, allowPositionals: true,
    options: {
      only: many, mesh: many, size: many, scheme: many, click: many,
      height: { type: 'string', default: '260' }, colours: { type: 'string' },
    },
  });
  if (positionals.length < 1 || positionals.length > 2)
    throw new Error('make_contact_sheet.sh [OPTION...] OUT [FOLDER]');
  const options = {
    only: kindsOfAll, mesh: [...Object.keys(generated), ...files], size: ['1400x900', '800x600', '400x800'],
    scheme: ['light', 'dark'], click: [], ...values, out: resolve(positionals[0]), folder: positionals[1],
  };
  for (const kind of options.only)
    if (!(kind in kinds))
      throw new Error(`--only ${kind}: not one of ${Object.keys(kinds).join(', ')}`);
  for (const size of options.size)
    if (!/^\d+x\d+$/.test(size))
      throw new Error(`--size ${size}: not like 1400x900`);
  for (const scheme of options.scheme)
    if (!['light', 'dark'].includes(scheme))
      throw new Error(`--scheme ${scheme}: neither light nor dark`);
  return options;
}

// The file of a mesh, made if it is of a kind that is generated; null if there is none.
function meshNamed(name, { out, folder }) {
  const made = join(out, 'meshes', `${name}.off`), given = join(folder ?? '', `${name}.off`);
  if (name in generated || name === 'sphere') {
    if (!existsSync(made))
      execFileSync(tool, ['generate', name, ...(generated[name] ?? []), '-q', '-o', made]);
    return made;
  }
  if (folder && existsSync(given))
    return given;
  console.error(`There is no ${given}`);
  return null;
}

// What is to be seen: a kind of page, and a mesh.
function subjectsOf(options) {
  const subjects = options.only.filter(kind => kind !== 'empty').flatMap(kind =>
    options.mesh.map(mesh => ({ kind, mesh })));
  if (options.only.includes('empty'))
    subjects.push({ kind: 'empty', mesh: 'sphere' });
  return subjects.map(subject => ({ ...subject, file: meshNamed(subject.mesh, options) })).filter(({ file }) => file);
}

const isNewer = (file, other) => existsSync(file) && statSync(file).mtimeMs > statSync(other).mtimeMs;

// Makes the page, unless one is there that is newer than the tool; says what went wrong.
function makePage({ kind, mesh, file }, { out }) {
  const page = join(out, 'pages', `${kind}_${mesh}.html`);
  if (isNewer(page, tool))
    return { page };
  const run = spawnSync(tool, [...kinds[kind], file, '-q', '--html', page], { cwd: join(out, 'pages') });
  return run.status === 0 ? { page } : { failure: `${kinds[kind].join(' ')}: ${run.stderr.toString().trim()}` };
}

async function open(browser, size, scheme) {
  const [width, height] = size.split('x').map(Number), isPhone = width < 500;
  const { page, complaints } = await newPage(browser);
  await page.setViewport({ width, height, deviceScaleFactor: 2, hasTouch: isPhone, isMobile: isPhone });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
  return { page, complaints };
}

// Takes the picture; says what the page complained of.
async function shoot(browser, file, size, scheme, clicks, picture) {
  const { page, complaints } = await open(browser, size, scheme);
  try {
    await page.goto(pathToFileURL(file).href);
    await page.waitForSelector('body.ready', { timeout: 60000 });
    for (const selector of clicks) {
      await page.click(selector);
      await new Promise(done => setTimeout(done, 800)); // the view may fly
    }
    await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
  } catch (error) {
    complaints.push(error.message);
  }
  await page.screenshot({ path: picture });
  await page.close();
  return complaints;
}

async function main() {
  const options = optionsOf(process.argv.slice(2)), { out } = options;
  for (const folder of ['meshes', 'pages', 'shots'])
    mkdirSync(join(out, folder), { recursive: true });
  const rows = [], remarks = [], began = Date.now();
  const browser = await launch('chromium');
  const say = remark => {
    console.log(remark);
    remarks.push(remark);
  };
  for (const subject of subjectsOf(options)) {
    const { page, failure } = makePage(subject, options), name = `${subject.kind} ${subject.mesh}`;
    if (failure) {
      say(`${name}: ${failure}`);
      continue;
    }
    const row = { name, shots: [] };
    for (const size of options.size)
      for (const scheme of options.scheme) {
        const shot = join(out, 'shots', `${subject.kind}_${subject.mesh}_${size}_${scheme}.png`);
        for (const complaint of await shoot(browser, page, size, scheme, options.click, shot))
          say(`${name} ${size} ${scheme}: ${complaint}`);
        row.shots.push({ file: shot, title: `${size} ${scheme}` });
      }
    rows.push(row);
  }
  await browser.close();
  writeFileSync(join(out, 'remarks.txt'), remarks.map(remark => `${remark}\n`).join(''));
  writeFileSync(join(out, 'sheet.json'), JSON.stringify(rows));
  const count = rows.reduce((sum, row) => sum + row.shots.length, 0);
  if (count > 0)
    execFileSync(process.env.PYTHON ?? 'python3', [
      join(root, 'test/web/contact_sheet.py'), join(out, 'sheet.json'), join(out, 'sheet.png'),
      '--height', options.height, ...(options.colours ? ['--colours', options.colours] : []),
    ], { stdio: 'inherit' });
  console.log(`${count} pictures of ${rows.length} pages in ${Math.round((Date.now() - began) / 1000)} s, ` +
              `${remarks.length} complaints: ${join(out, 'sheet.png')}`);
  process.exitCode = remarks.length > 0 || count === 0 ? 1 : 0;
}

await main().catch(error => {
  console.error(error.message);
  process.exitCode = 2;
});
