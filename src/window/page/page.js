// The page: shows the scene, and reacts to the user.

const scene = JSON.parse(element('scene').textContent);

class Page {
  constructor(viewer) {
    this.viewer = viewer;
    this.lit = -1;
    this.groupsShown = scene.groups.map(() => true);
    this.ways = new Set(scene.lines.map(line => line.way)); // shown for the lit row
    this.overlay = new Overlay(viewer, scene);
    this.table = new Table(scene, (...row) => this.light(...row), () => this.refresh());
    this.makeTexts();
    this.filters = new Filters(this);
    this.switches = new Switches(this);
    this.saving = new Saving(this);
    this.pointers = new Pointers(this);
    viewer.listeners.push(() => this.switches.refreshForView());
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
    const hints = matchMedia('(pointer: coarse)').matches
      ? ['drag: turn', 'two fingers: move, zoom, roll', 'tap: select a loop', 'double tap: set the center']
      : ['drag: turn', 'shift or right button: move', 'wheel: zoom', 'double click: set the center'];
    element('hint').textContent = hints.join(' \u00b7 ');
    const example = scene.columns.find(column => column.number && column !== scene.columns[0]);
    element('search').placeholder = example ? `search, for example ${example.name} < 2` : 'search';
  }

  // ---- what is shown

  refresh() {
    const { viewer, table } = this;
    table.refresh(this.lit);
    let count = 0;
    const colours = scene.lines.map((line, i) => {
      const row = table.rows[line.row], isOfLit = row?.index === this.lit;
      const shown = this.groupsShown[line.group] && (!row || !row.node.hidden) && // all lines of a lit row
                    (isOfLit || !this.ways.has(i) && (line.surface ?? viewer.shown) === viewer.shown);
      count += shown ? 1 : 0;
      const state = !shown ? 0 : isOfLit ? 255 : 128;
      return [...(table.isColoured && row ? table.colourOf(row) : scene.groups[line.group].colour), state];
    });
    viewer.numberShown = count;
    viewer.isAnyLit = this.lit >= 0;
    viewer.fillLines(colours);
    viewer.surfaces.forEach((_, i) => this.refreshParts(i));
    this.refreshCard();
    this.refreshChoice();
  }

  // All parts except that of the lit row are pale.
  refreshParts(number) {
    const { parts, colour } = scene.surfaces[number], lit = scene.parts[this.lit] ?? undefined;
    this.viewer.fillParts(number, (parts || [colour]).map((own, part) => [
      ...(parts && lit !== undefined && part !== lit ? own.map(c => 150 + c / 3) : own), 255]));
  }

  refreshCard() {
    const row = this.table.rows[this.lit], card = element('card');
    withdraw(card, 'hidden', !row);
    if (!row)
      return;
    const [[name, cell], ...others] = this.table.namesAndCells(row), list = made('dl');
    list.append(...others.map(([term, text]) =>
      made('div', {}, made('dt', { textContent: term }), made('dd', { textContent: text }))));
    const button = (text, label, by) => {
      const node = made('button', { type: 'button', textContent: text, title: label, onclick: () => this.step(by) });
      node.setAttribute('aria-label', label);
      return node;
    };
    const steps = made('div', {}, button('\u2039', 'previous (p)', -1), button('\u203a', 'next (n)', 1));
    const focused = [...card.querySelectorAll('button')].indexOf(document.activeElement);
    card.replaceChildren(made('h2', { textContent: `${name} ${cell}` }), list, steps);
    if (focused >= 0)
      steps.children[focused].focus();
  }

  refreshChoice() {
    const { rows, chosen } = this.table, hidden = chosen.filter(row => row.node.hidden).length;
    element('count').textContent = !rows.length ? ''
      : `${this.table.shown.length} of ${rows.length} shown` +
        (hidden ? `; ${hidden} of ${chosen.length} chosen are hidden` : '');
    const numbers = chosen.map(row => scene.numbers[row.index]);
    element('choice').value = chosen.length ? scene.choice[0] + numbers.join(',') + scene.choice[1] : '';
    element('command').hidden = scene.numbers.length === 0;
    ['copy', 'clear'].forEach(id => withdraw(element(id), 'disabled', chosen.length === 0));
    const told = numbers.join(); // to a page around this one, which may use them
    if (window.parent !== window && told !== this.told)
      window.parent.postMessage({ chosen: numbers }, '*');
    this.told = told;
  }

  // Lights a row and its lines, and flies there if `isLookedAt`.
  light(index, isLookedAt) {
    this.lit = index;
    const row = this.table.rows[index];
    this.refresh();
    if (!row)
      return;
    const all = row.lines.map(i => scene.lines[i]), loops = all.filter(line => !scene.groups[line.group].aside);
    const lines = loops.length > 0 ? loops : all;
    this.viewer.normalOfLoop = lines.length > 0 ? normalOf(this.viewer.pointsOfLine(lines[0])) : null;
    if (isLookedAt)
      this.viewer.lookAt(lines, scene.views[index]);
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
    if (this.isMeasuring)
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
    this.note(length === null ? 'Click the second point.' : '');
    this.overlay.draw();
  }

  get isMeasuring() {
    return element('measure').getAttribute('aria-pressed') === 'true';
  }

  toggleMeasuring() {
    const isOn = !this.isMeasuring;
    element('measure').setAttribute('aria-pressed', isOn);
    this.viewer.canvas.parentElement.classList.toggle('measuring', isOn);
    this.overlay.ends = [];
    this.note(isOn ? 'Click two points on the surface.' : '');
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

  // Shows a text for a moment.
  note(text) {
    clearTimeout(this.noting);
    element('note').textContent = text;
    if (!this.isMeasuring)
      this.noting = setTimeout(() => this.note(''), 6000);
  }

  closeMenus() {
    document.querySelectorAll('.menu[open]').forEach(menu => {
      if (menu.contains(document.activeElement))
        menu.querySelector('summary').focus();
      menu.open = false;
    });
  }

  // Ends one thing at a time: an open menu, measuring, a flight, the lit row.
  escape() {
    if (document.querySelector('.menu[open]'))
      this.closeMenus();
    else if (this.isMeasuring)
      this.toggleMeasuring();
    else if (this.viewer.canGoBack)
      this.viewer.goBack();
    else
      this.light(-1, false);
  }

  // Everything except lit and chosen rows.
  reset() {
    if (this.isMeasuring)
      this.toggleMeasuring();
    this.switches.reset();
    this.filters.reset();
    this.refresh();
    this.viewer.goHome();
  }
}

// The normal of a nearly flat closed line, by Newell's method.
function normalOf(points) {
  const area = points.reduce((all, p, i) => sum(all, cross(p, points[(i + 1) % points.length])), [0, 0, 0]);
  return Math.hypot(...area) > 0 ? normalized(area) : null;
}
