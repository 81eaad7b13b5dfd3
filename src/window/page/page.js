// The page: what is shown of the scene, and the switches.

const scene = JSON.parse(element('scene').textContent);

class Page {
  constructor(viewer) {
    this.viewer = viewer;
    this.lit = -1;
    this.groupsShown = scene.groups.map(() => true);
    this.overlay = new Overlay(viewer, scene);
    this.table = new Table(scene, (...row) => this.light(...row), () => this.refresh());
    this.makeTexts();
    this.makeLegend();
    this.makeFilters();
    this.makeSwitches();
    this.makeSaving();
    this.pointers = new Pointers(this);
    viewer.listeners.push(() => this.refreshTools());
    new ResizeObserver(() => viewer.draw()).observe(viewer.canvas);
    matchMedia('(prefers-color-scheme: dark)').onchange = () => this.takeTheme();
    this.takeTheme();
    this.refresh();
  }

  takeTheme() {
    const colour = getComputedStyle(this.viewer.canvas.parentElement).backgroundColor;
    this.viewer.background = colour.match(/[\d.]+/g).slice(0, 3).map(x => x / 255);
    this.viewer.draw();
  }

  makeTexts() {
    const about = element('about'), first = about.querySelector('p');
    about.querySelector('summary').textContent = first ? first.textContent : '';
    about.hidden = !first;
    first?.remove();
    element('empty').textContent = scene.empty;
    element('empty').hidden = scene.empty === '';
    const isTouched = matchMedia('(pointer: coarse)').matches;
    element('hint').textContent = isTouched ? 'drag: turn \u00b7 two fingers: move, zoom, roll \u00b7 tap: which loop \u00b7 tap twice: turn about it'
      : 'drag: turn \u00b7 shift or right button: move \u00b7 wheel: zoom \u00b7 double click: turn about it';
    const example = scene.columns.find(column => column.number && column !== scene.columns[0]);
    element('search').placeholder = example ? `search, or for example ${example.name} < 2` : 'search';
  }

  // ---- what is shown

  refresh() {
    const { viewer, table } = this;
    table.refresh(this.lit);
    let count = 0;
    const colours = scene.lines.map(line => {
      const row = table.rows[line.row];
      const shown = this.groupsShown[line.group] && (!row || !row.node.hidden || row.index === this.lit) &&
                    (line.surface ?? viewer.shown) === viewer.shown;
      count += shown ? 1 : 0;
      const state = !shown ? 0 : row && row.index === this.lit ? 255 : 128;
      return [...(table.isColoured && row ? table.colourOf(row) : scene.groups[line.group].colour), state];
    });
    viewer.numberShown = count;
    viewer.isAnyLit = this.lit >= 0;
    viewer.fillLines(colours);
    viewer.surfaces.forEach((_, i) => this.refreshParts(i));
    this.refreshCard();
    this.refreshChoice();
  }

  // All parts but that of the lit row are pale.
  refreshParts(number) {
    const { parts, colour } = scene.surfaces[number], lit = scene.parts[this.lit] ?? undefined;
    this.viewer.fillParts(number, (parts || [colour]).map((own, part) => [
      ...(parts && lit !== undefined && part !== lit ? own.map(c => 150 + c / 3) : own), 255]));
  }

  refreshCard() {
    const row = this.table.rows[this.lit], card = element('card');
    card.hidden = !row;
    if (!row)
      return;
    const [[name, cell], ...others] = this.table.namesAndCells(row), list = made('dl');
    others.forEach(([term, text]) => list.append(made('dt', { textContent: term }), made('dd', { textContent: text })));
    const button = (text, label, by) => {
      const node = made('button', { type: 'button', textContent: text, title: label, onclick: () => this.step(by) });
      node.setAttribute('aria-label', label);
      return node;
    };
    card.replaceChildren(made('h2', { textContent: `${name} ${cell}` }), list,
                         made('div', {}, button('\u2039', 'the one before (p)', -1), button('\u203a', 'the next one (n)', 1)));
  }

  refreshChoice() {
    const { rows, chosen } = this.table, hidden = chosen.filter(row => row.node.hidden).length;
    element('count').textContent = !rows.length ? ''
      : `${this.table.shown.length} of ${rows.length} shown` +
        (hidden ? `; ${hidden} of ${chosen.length} chosen are hidden` : '');
    const numbers = chosen.map(row => scene.numbers[row.index]);
    element('choice').value = chosen.length ? scene.choice[0] + numbers.join(',') + scene.choice[1] : '';
    element('command').hidden = scene.numbers.length === 0;
    element('copy').disabled = element('clear').disabled = chosen.length === 0;
    if (window.parent !== window) // a page around this one may do something with them
      window.parent.postMessage({ chosen: numbers }, '*');
  }

  refreshTools() {
    element('back').disabled = !this.viewer.canGoBack;
    element('open').checked = this.viewer.camera.isCutOpen;
    element('open').disabled = this.lit < 0;
  }

  // Lights a row and its lines, and flies there if that is wanted.
  light(index, isLookedAt) {
    this.lit = index;
    const row = this.table.rows[index];
    this.refresh();
    if (!row)
      return;
    const lines = row.lines.map(i => scene.lines[i]);
    this.viewer.normalOfLoop = lines.length > 0 ? normalOf(this.viewer.pointsOfLine(lines[0])) : null;
    if (isLookedAt)
      this.viewer.lookAt(lines, scene.views[index]);
    row.node.hidden = false;
    row.node.scrollIntoView({ block: 'nearest' });
  }

  step(by) {
    const { shown } = this.table, at = shown.findIndex(row => row.index === this.lit);
    if (shown.length === 0)
      return;
    const next = at < 0 ? (by > 0 ? 0 : shown.length - 1) : (at + by + shown.length) % shown.length;
    this.light(shown[next].index, true);
  }

  // ---- what is done

  click(x, y) {
    if (element('measure').getAttribute('aria-pressed') === 'true')
      return this.measure(x, y);
    const line = this.viewer.pick(x, y);
    this.light(line < 0 ? -1 : scene.lines[line].row ?? -1, false);
  }

  measure(x, y) {
    const place = this.viewer.placeAt(x, y), { ends } = this.overlay;
    if (!place)
      return;
    this.overlay.ends = ends.length === 1 ? [...ends, place] : [place];
    const length = this.overlay.lengthMeasured;
    this.say(length === null ? 'Now the other end.' : `${this.overlay.wordsOf(length)} between these points`);
    this.overlay.draw();
  }

  showTip(line, x, y) {
    const tip = element('tip'), row = this.table.rows[scene.lines[line]?.row];
    tip.hidden = line < 0;
    if (line < 0)
      return;
    tip.textContent = row ? this.table.namesAndCells(row).filter((_, i) => i < 6).map(pair => pair.join(' ')).join('\n')
                          : scene.groups[scene.lines[line].group].name;
    const { clientWidth, clientHeight } = this.viewer.canvas;
    Object.assign(tip.style, {
      left: `${Math.min(x + 14, clientWidth - tip.offsetWidth - 6)}px`,
      top: `${Math.min(y + 14, clientHeight - tip.offsetHeight - 6)}px`,
    });
  }

  say(text, isBad = false) {
    element('message').textContent = text;
    element('message').classList.toggle('bad', isBad);
  }

  closeMenus() {
    document.querySelectorAll('.menu[open]').forEach(menu => { menu.open = false; });
  }

  // One thing after the other: an open menu, measuring, where one flew to, the lit row.
  escape() {
    if (document.querySelector('.menu[open]'))
      this.closeMenus();
    else if (element('measure').getAttribute('aria-pressed') === 'true')
      element('measure').click();
    else if (this.viewer.canGoBack)
      this.viewer.goBack();
    else
      this.light(-1, false);
  }

  // All but what was lit and chosen.
  reset() {
    const { viewer, table } = this, { shown } = viewer;
    viewer.setDefaults(scene);
    viewer.shown = shown;
    viewer.camera.home.up = scene.up;
    this.groupsShown.fill(true);
    document.querySelectorAll('#legend input[type=checkbox]').forEach(box => { box.checked = true; });
    Object.assign(table, { search: '', isColoured: false });
    Object.assign(element('search'), { value: '' });
    Object.assign(element('scale'), { selectedIndex: 0 });
    table.chooseScale(0);
    this.refreshFilters();
    this.refreshSwitches();
    this.refresh();
    viewer.goHome();
  }

  // ---- controls

  makeLegend() {
    const legend = element('legend'), { viewer } = this;
    scene.groups.forEach((group, i) => {
      const count = scene.lines.filter(line => line.group === i).length;
      if (count === 0)
        return;
      const box = made('input', { type: 'checkbox', checked: true, id: `group${i}` });
      box.onchange = () => {
        this.groupsShown[i] = box.checked;
        this.refresh();
      };
      const mark = made('span', { className: 'mark' });
      mark.style.background = `rgb(${group.colour})`;
      legend.append(made('label', {}, box, mark, group.name));
    });
    scene.patches.forEach(({ name, colour }) => {
      const mark = made('span', { className: 'mark patch' });
      mark.style.background = `rgb(${colour})`;
      legend.append(made('label', {}, mark, name));
    });
    if (scene.surfaces.length > 1)
      scene.surfaces.forEach((surface, i) => {
        const radio = made('input', { type: 'radio', name: 'surface', checked: i === 0, id: `show${i}` });
        radio.onchange = () => {
          viewer.shown = i;
          this.refresh();
        };
        legend.append(made('label', {}, radio, surface.name));
      });
  }

  makeFilters() {
    const { table } = this, choice = element('scale'), colours = element('colours').querySelector('input');
    choice.append(...table.scales.map(({ name }, i) => made('option', { value: i, textContent: name })));
    choice.onchange = () => {
      table.chooseScale(Number(choice.value));
      this.refreshFilters();
      this.refresh();
    };
    colours.onchange = () => {
      table.isColoured = colours.checked;
      this.refreshFilters();
      this.refresh();
    };
    element('search').oninput = () => {
      table.search = element('search').value;
      this.refresh();
    };
    ['shortest', 'longest'].forEach((id, i) => {
      element(id).oninput = () => this.setRange(i, Number(element(id).value));
      element(`${id}-value`).onchange = event => {
        const value = Number(event.target.value), { steps } = table;
        const step = i === 0 ? steps.findIndex(x => x >= value) : steps.filter(x => x <= value).length - 1;
        this.setRange(i, event.target.value === '' ? i * (steps.length - 1) : step < 0 ? (1 - i) * (steps.length - 1) : step);
      };
    });
    element('filters').hidden = table.rows.length === 0;
    this.refreshFilters();
  }

  setRange(end, step) {
    const { range } = this.table;
    range[end] = step;
    if (range[0] > range[1])
      range[1 - end] = step;
    this.refreshFilters();
    this.refresh();
  }

  refreshFilters() {
    const { steps, range, scale, isColoured } = this.table, last = steps.length - 1;
    const words2 = scale.name === 'length' ? ['shortest', 'longest'] : ['smallest', 'largest'];
    const what = scale.name === 'length' ? scene.noun : scale.name;
    ['shortest', 'longest'].forEach((id, i) => {
      element(`${id}-words`).textContent = `${words2[i]} ${what} shown`;
      Object.assign(element(id), { min: 0, max: Math.max(0, last), value: range[i], disabled: last < 1 });
      Object.assign(element(`${id}-value`), { value: last < 0 ? '' : Number(steps[range[i]].toPrecision(5)), disabled: last < 1 });
      element(`${id}-value`).setAttribute('aria-label', `${words2[i]} ${what} shown`);
    });
    element('colours').querySelector('input').checked = isColoured;
    const gradient = element('gradient');
    gradient.hidden = !isColoured || last < 0;
    if (!gradient.hidden)
      [gradient.firstElementChild.textContent, gradient.lastElementChild.textContent] = [steps[0], steps[last]].map(words);
  }

  makeSwitches() {
    const { viewer } = this, change = (id, action, event = 'onchange') => {
      element(id)[event] = () => {
        action(element(id));
        this.refreshSwitches();
        viewer.draw();
      };
    };
    change('opacity', node => { viewer.opacity = node.value / 100; }, 'oninput');
    change('cut', node => { viewer.cut.part = node.value / 1000; }, 'oninput');
    change('axis', node => { viewer.cut.direction = node.value; });
    change('wire', node => { viewer.isWired = node.checked; });
    change('thick', node => { viewer.isThick = node.checked; });
    change('open', node => { viewer.camera.front = node.checked ? this.frontOfLit() : Camera.everything; });
    change('up', node => {
      const sign = node.value[0] === '-' ? -1 : 1;
      viewer.camera.home.up = node.value ? [...'xyz'].map(axis => node.value.endsWith(axis) ? sign : 0) : scene.up;
      viewer.flyTo(viewer.camera.poseFrom(viewer.camera.back, viewer.camera.place, viewer.camera.distance, viewer.camera.front));
    });
    element('reset').onclick = () => this.reset();
    element('back').onclick = () => viewer.goBack();
    element('measure').onclick = () => this.toggleMeasuring();
    this.makeButtons();
    this.makeBalls();
    element('thickness').hidden = !scene.lines.some(line => line.radii);
    this.refreshSwitches();
  }

  makeButtons() {
    const toggle = (id, name, attribute) => {
      element(id).onclick = () => {
        const isOn = document.body.classList.toggle(name);
        element(id).setAttribute(attribute, attribute === 'aria-expanded' && id === 'panel' ? !isOn : isOn);
        this.viewer.draw();
      };
    };
    toggle('panel', 'alone', 'aria-expanded');
    toggle('sheet', 'open', 'aria-expanded');
    toggle('wide', 'wide', 'aria-pressed');
    element('full').hidden = !document.fullscreenEnabled;
    element('full').onclick = () => {
      if (document.fullscreenElement)
        document.exitFullscreen();
      else
        document.documentElement.requestFullscreen().catch(() => this.say('This browser does not let a page fill the screen.', true));
    };
    element('copy').onclick = () => this.copy();
    element('clear').onclick = () => {
      for (const row of this.table.rows)
        row.chosen = row.box.checked = false;
      this.refreshChoice();
    };
    document.querySelectorAll('.menu').forEach(menu => {
      menu.ontoggle = () => document.querySelectorAll('.menu[open]').forEach(other => {
        other.open = other === menu || !menu.open;
      });
    });
  }

  refreshSwitches() {
    const { viewer } = this;
    element('opacity').value = 100 * viewer.opacity;
    element('opacity').nextElementSibling.textContent = `${Math.round(100 * viewer.opacity)}%`;
    element('cut').value = 1000 * viewer.cut.part;
    element('cut').nextElementSibling.textContent = viewer.cut.part >= 1 ? 'all' : `${Math.round(100 * viewer.cut.part)}%`;
    element('axis').value = viewer.cut.direction;
    element('wire').checked = viewer.isWired;
    element('thick').checked = viewer.isThick;
    if (viewer.camera.home.up === scene.up)
      element('up').value = '';
  }

  // What of the space before the lit lines stays.
  frontOfLit() {
    const places = this.table.rows[this.lit].lines.flatMap(i => this.viewer.pointsOfLine(scene.lines[i]));
    const { camera } = this.viewer, nearest = places.reduce((most, p) => Math.max(most, dot(difference(p, camera.place), camera.back)), 0);
    return Math.max(nearest * 1.1, 1e-3);
  }

  toggleMeasuring() {
    const button = element('measure'), isOn = button.getAttribute('aria-pressed') !== 'true';
    button.setAttribute('aria-pressed', isOn);
    this.viewer.canvas.parentElement.classList.toggle('measuring', isOn);
    this.overlay.ends = [];
    this.say(isOn ? 'Click two points of the surface.' : '');
    this.overlay.draw();
  }

  // Lines that have a way are moved along it, from its first point.
  makeBalls() {
    const { viewer } = this, balls = scene.lines.filter(line => line.way !== undefined);
    const home = balls.length > 0 ? viewer.linePoints.slice() : null;
    document.querySelectorAll('.ball').forEach(node => { node.hidden = balls.length === 0; });
    element('ball').oninput = () => {
      const part = Number(element('ball').value) / 1000;
      for (const ball of balls)
        viewer.shiftLine(ball, home, placeOn(home, scene.lines[ball.way], part, viewer.placing.scale));
      viewer.refillLines();
    };
  }

  // ---- what leaves the page

  makeSaving() {
    const { canvas } = this.viewer, ratio = window.devicePixelRatio || 1, sides = ['width', 'height'].map(element);
    element('save').closest('.menu').addEventListener('toggle', () => {
      if (!sides[0].value)
        [sides[0].value, sides[1].value] = [canvas.clientWidth, canvas.clientHeight].map(x => Math.round(x * ratio));
    });
    element('save').onclick = () => this.save();
  }

  // As large as the picture on the page, if nothing else was asked for.
  save() {
    const { viewer } = this, { renderer } = viewer, ratio = window.devicePixelRatio || 1;
    if (!viewer.isReady)
      return this.say('There is no picture to save.', true);
    const [width, height] = ['width', 'height'].map((id, i) =>
      clamped(Math.round(Number(element(id).value) || [viewer.canvas.clientWidth, viewer.canvas.clientHeight][i] * ratio), 16, renderer.largestSide));
    const { aspect } = viewer.camera, drawn = made('canvas', { width, height });
    viewer.camera.aspect = width / height;
    const image = renderer.image(viewer, width, height, element('clear-background').checked ? [0, 0, 0, 0] : [...viewer.background, 1]);
    viewer.camera.aspect = aspect;
    viewer.draw();
    drawn.getContext('2d').putImageData(image, 0, 0);
    drawn.toBlob(blob => {
      if (!blob)
        return this.say('This browser cannot make a picture of that size.', true);
      const link = made('a', { href: URL.createObjectURL(blob), download: `${scene.name}.png` });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
    this.closeMenus();
  }

  copy() {
    element('choice').select();
    if (navigator.clipboard && window.isSecureContext)
      navigator.clipboard.writeText(element('choice').value).catch(() => document.execCommand('copy'));
    else
      document.execCommand('copy');
  }
}

// Of a closed line that is about flat, by Newell.
function normalOf(points) {
  const area = points.reduce((all, p, i) => sum(all, cross(p, points[(i + 1) % points.length])), [0, 0, 0]);
  return Math.hypot(...area) > 0 ? normalized(area) : null;
}
