// The table beside the surface, and what the mouse, fingers and keys do.

const scene = JSON.parse(document.getElementById('scene').textContent);
const element = id => document.getElementById(id);

function made(tag, properties = {}, ...children) {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
}

// A place is sorted by its first coordinate, a box by its largest extent, words as such.
function sizeIn(text) {
  const numbers = (/^\(?-?\d/.test(text) && text.match(/-?\d[\d.]*(e[+-]?\d+)?/g) || [0]).map(Number);
  return text.includes('\u00d7') ? Math.max(...numbers) : numbers[0];
}

// From red, for the smallest, over yellow to blue.
function tint(part) {
  const stops = [[190, 20, 40], [235, 180, 40], [40, 90, 190]], at = 2 * part, i = Math.min(1, Math.floor(at));
  return stops[i].map((c, k) => Math.round(c + (at - i) * (stops[i + 1][k] - c)));
}

class Page {
  constructor(viewer) {
    this.viewer = viewer;
    this.canvas = viewer.canvas;
    this.rows = scene.rows.map((cells, index) => ({ cells, index, lines: [], chosen: false }));
    scene.lines.forEach((line, i) => this.rows[line.row]?.lines.push(i));
    this.groupsShown = scene.groups.map(() => true);
    this.lit = -1;
    this.scales = [{ name: 'length', values: scene.lengths }, ...scene.scales];
    this.isColoured = false;
    this.choose(0);
    this.makeTable();
    this.makeControls();
    this.listenToPointers();
    this.listenToKeys();
    new ResizeObserver(() => viewer.draw()).observe(this.canvas);
    this.refresh();
  }

  // ---- what is shown

  // By what rows are hidden. What is not known is shown as long as all is.
  choose(number) {
    this.values = this.scales[number].values;
    this.lengths = [...new Set(this.values.filter(v => v !== null))].sort((a, b) => a - b);
    this.range = [0, this.lengths.length - 1];
  }

  isShown(row) {
    const value = this.values[row.index], [first, last] = this.range;
    if (value === null)
      return first === 0 && last === this.lengths.length - 1;
    return value >= this.lengths[first] && value <= this.lengths[last];
  }

  // Evenly over the values that there are; grey where none is known.
  colourOf(row) {
    const value = this.values[row.index], last = Math.max(1, this.lengths.length - 1);
    return value === null ? [140, 140, 140] : tint(this.lengths.indexOf(value) / last);
  }

  refresh() {
    let count = 0;
    const colours = scene.lines.map((line, i) => {
      const row = this.rows[line.row];
      const shown = this.groupsShown[line.group] && (!row || this.isShown(row)) &&
                    (line.surface ?? this.viewer.shown) === this.viewer.shown;
      count += shown ? 1 : 0;
      const state = !shown ? 0 : row && row.index === this.lit ? 255 : 128;
      const own = line.colour || scene.groups[line.group].colour;
      return [...(this.isColoured && row ? this.colourOf(row) : own), state];
    });
    this.viewer.numberShown = count;
    this.viewer.isAnyLit = this.lit >= 0;
    this.viewer.fill(this.viewer.lines.palette, colours);
    this.viewer.surfaces.forEach((surface, i) => {
      const parts = scene.surfaces[i].parts || [scene.surfaces[i].colour];
      const lit = scene.parts[this.lit];
      this.viewer.fill(surface.palette, parts.map((colour, part) => [
        ...(lit !== undefined && part !== lit ? colour.map(c => 150 + c / 3) : colour), 255]));
    });
    for (const row of this.rows) {
      row.node.hidden = !this.isShown(row);
      row.node.classList.toggle('lit', row.index === this.lit);
      row.node.setAttribute('aria-selected', row.index === this.lit);
    }
    this.refreshChoice();
  }

  refreshChoice() {
    const { rows } = this, chosen = rows.filter(row => row.chosen);
    const hidden = chosen.filter(row => row.node.hidden).length;
    element('count').textContent = !rows.length ? ''
      : `${rows.filter(row => !row.node.hidden).length} of ${rows.length} shown` +
        (hidden ? `; ${hidden} of ${chosen.length} chosen are hidden` : '');
    element('choice').value =
      chosen.length ? `${scene.choice} ${chosen.map(row => scene.numbers[row.index]).join(',')}` : '';
    element('choice').hidden = element('copy').hidden = element('clear').hidden = scene.numbers.length === 0;
    element('copy').disabled = element('clear').disabled = chosen.length === 0;
    if (window.parent !== window) // a page around this one may do something with them
      window.parent.postMessage({ chosen: chosen.map(row => scene.numbers[row.index]) }, '*');
  }

  // Lights a row and its lines, and brings them to the middle if that is wanted.
  light(index, isCentred) {
    this.lit = index;
    const row = this.rows[index];
    if (row) {
      if (isCentred)
        this.centre(row);
      row.node.hidden = false;
      row.node.scrollIntoView({ block: 'nearest' });
    }
    this.refresh();
  }

  centre(row) {
    const places = row.lines.flatMap(i => {
      const { first, last } = scene.lines[i];
      return Array.from({ length: last - first + 1 }, (_, k) => this.viewer.pointOfLine(first + k));
    });
    if (places.length === 0)
      return;
    const low = [0, 1, 2].map(i => places.reduce((m, p) => Math.min(m, p[i]), Infinity));
    const high = [0, 1, 2].map(i => places.reduce((m, p) => Math.max(m, p[i]), -Infinity));
    this.viewer.lookAt(row.lines, scaled(sum(low, high), .5), Math.hypot(...difference(high, low)) / 2);
  }

  step(by) {
    const shown = [...element('rows').children].filter(node => !node.hidden);
    if (shown.length === 0)
      return;
    const at = shown.findIndex(node => node.row.index === this.lit);
    const next = at < 0 ? (by > 0 ? 0 : shown.length - 1) : (at + by + shown.length) % shown.length;
    this.light(shown[next].row.index, true);
  }

  // ---- the table

  makeTable() {
    const head = element('head'), body = element('rows');
    head.append(made('th'));
    scene.columns.forEach((column, i) => {
      const button = made('button', { type: 'button', textContent: column.name, title: 'sort by it' });
      button.onclick = () => this.sort(i);
      head.append(made('th', { className: column.number ? 'n' : '' }, button));
    });
    for (const row of this.rows) {
      const box = made('input', { type: 'checkbox', title: 'choose', hidden: !(row.index in scene.numbers) });
      box.onclick = event => event.stopPropagation();
      box.onchange = () => {
        row.chosen = box.checked;
        this.refreshChoice();
      };
      row.box = box;
      row.node = made('tr', { row, tabIndex: 0 }, made('td', {}, box));
      row.cells.forEach((cell, i) => row.node.append(
        made('td', { className: scene.columns[i].number ? 'n' : '', textContent: cell })));
      row.node.onclick = () => this.light(row.index, true);
      row.node.onkeydown = event => {
        if (event.key === 'Enter')
          this.light(row.index, true);
      };
      body.append(row.node);
    }
    element('table').hidden = this.rows.length === 0;
  }

  sort(column) {
    this.descending = this.sorted === column && !this.descending;
    this.sorted = column;
    const sign = this.descending ? -1 : 1, { number } = scene.columns[column];
    const value = row => number ? parseFloat(row.cells[column]) || 0 : sizeIn(row.cells[column]);
    const order = (a, b) => value(a) - value(b) || a.cells[column].localeCompare(b.cells[column]);
    const rows = [...this.rows].sort((a, b) => sign * order(a, b) || a.index - b.index);
    element('rows').append(...rows.map(row => row.node));
    [...element('head').children].forEach((node, i) => node.setAttribute(
      'aria-sort', i !== column + 1 ? 'none' : this.descending ? 'descending' : 'ascending'));
  }

  // ---- the controls

  makeControls() {
    const { viewer } = this;
    scene.groups.forEach((group, i) => {
      if (!scene.lines.some(line => line.group === i))
        return;
      const box = made('input', { type: 'checkbox', checked: true, id: `group${i}` });
      box.onchange = () => {
        this.groupsShown[i] = box.checked;
        this.refresh();
      };
      const mark = made('span', { className: 'mark' });
      mark.style.background = `rgb(${group.colour})`;
      element('legend').append(made('label', {}, box, mark, group.name));
    });
    if (scene.lines.some(line => line.radii)) {
      const box = made('input', { type: 'checkbox', id: 'thick' });
      box.onchange = () => {
        viewer.isThick = box.checked;
        viewer.draw();
      };
      element('legend').append(made('label', {}, box, 'as thick as the solid'));
    }
    if (scene.surfaces.length > 1)
      scene.surfaces.forEach((surface, i) => {
        const radio = made('input', { type: 'radio', name: 'surface', checked: i === 0, id: `show${i}` });
        radio.onchange = () => {
          viewer.shown = i;
          this.refresh();
        };
        element('legend').append(made('label', {}, radio, surface.name));
      });
    const slider = (id, action) => {
      element(id).oninput = () => action(Number(element(id).value));
    };
    element('opacity').value = 100 * viewer.opacity;
    slider('opacity', value => {
      viewer.opacity = value / 100;
      viewer.draw();
    });
    slider('cut', value => {
      viewer.cut.part = value / 1000;
      viewer.draw();
    });
    element('axis').onchange = () => {
      viewer.cut.axis = Number(element('axis').value) % 4;
      viewer.cut.flipped = element('axis').value >= 4;
      viewer.draw();
    };
    this.makeScales();
    this.makeBalls();
    this.makeRange();
    element('reset').onclick = () => this.reset();
    element('save').onclick = () => this.save();
    element('copy').onclick = () => this.copy();
    element('clear').onclick = () => {
      for (const row of this.rows)
        row.chosen = row.box.checked = false;
      this.refreshChoice();
    };
  }

  makeScales() {
    const choice = element('scale'), box = element('colours').querySelector('input');
    choice.append(...this.scales.map(({ name }, i) => made('option', { value: i, textContent: name })));
    choice.onchange = () => {
      this.choose(Number(choice.value));
      this.makeRange();
      this.refresh();
    };
    box.onchange = () => {
      this.isColoured = box.checked;
      this.refresh();
    };
    for (const node of [choice.previousElementSibling, choice, element('colours')])
      node.hidden = this.scales.length < 2;
  }

  // Lines that have a way are moved along it, from its first point.
  makeBalls() {
    const { viewer } = this, balls = scene.lines.filter(line => line.way !== undefined);
    const home = balls.length > 0 ? viewer.lines.points.slice() : null;
    document.querySelectorAll('.ball').forEach(node => { node.hidden = balls.length === 0; });
    element('ball').oninput = () => {
      const part = Number(element('ball').value) / 1000;
      for (const ball of balls)
        viewer.shiftLine(ball, home, placeOn(home, scene.lines[ball.way], part, viewer.scale));
      viewer.refillLines();
    };
  }

  makeRange() {
    const last = this.lengths.length - 1, ends = ['shortest', 'longest'].map(element);
    const show = () => ends.forEach((end, i) => {
      element(`${end.id}-value`).textContent = last < 0 ? '' : Number(this.lengths[this.range[i]]).toPrecision(4);
    });
    element('range').hidden = last < 1 && this.scales.length < 2;
    ends.forEach((end, i) => {
      Object.assign(end, { min: 0, max: last, value: this.range[i] });
      end.oninput = () => {
        this.range[i] = Number(end.value);
        if (this.range[0] > this.range[1])
          ends[1 - i].value = this.range[1 - i] = this.range[i];
        show();
        this.refresh();
      };
    });
    show();
  }

  reset() {
    this.viewer.camera.reset();
    this.light(-1, false);
  }

  // The picture is taken in the moment in which it is drawn: later it is gone.
  save() {
    this.viewer.drawNow();
    this.canvas.toBlob(blob => {
      const link = made('a', { href: URL.createObjectURL(blob), download: `${scene.name}.png` });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }

  copy() {
    element('choice').select();
    if (navigator.clipboard && window.isSecureContext)
      navigator.clipboard.writeText(element('choice').value).catch(() => document.execCommand('copy'));
    else
      document.execCommand('copy');
  }

  // ---- pointers and keys

  listenToPointers() {
    const { canvas, viewer } = this, { camera } = viewer, pointers = new Map();
    let moved = 0;
    const at = event => [event.offsetX, event.offsetY];
    canvas.onpointerdown = event => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, at(event));
      moved = pointers.size > 1 ? Infinity : 0;
      canvas.focus({ preventScroll: true });
    };
    canvas.onpointermove = event => {
      const before = pointers.get(event.pointerId);
      if (!before)
        return;
      const now = at(event), [dx, dy] = [now[0] - before[0], now[1] - before[1]];
      moved += Math.hypot(dx, dy);
      const height = canvas.clientHeight;
      const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
      pointers.set(event.pointerId, now);
      if (other) {
        const [u, v] = [difference(before, other), difference(now, other)];
        camera.zoom(Math.hypot(...u) / Math.max(Math.hypot(...v), 1));
        camera.roll(Math.atan2(v[1], v[0]) - Math.atan2(u[1], u[0]));
        camera.pan(dx / 2 / height, -dy / 2 / height);
      } else if (event.shiftKey || event.buttons & 6) {
        camera.pan(dx / height, -dy / height);
      } else {
        camera.turn(dx / height * 4, dy / height * 4);
      }
      viewer.move();
    };
    canvas.onpointerup = event => {
      pointers.delete(event.pointerId);
      if (moved < 5 && event.button === 0)
        this.click(...at(event));
    };
    canvas.onpointercancel = event => pointers.delete(event.pointerId);
    canvas.oncontextmenu = event => event.preventDefault();
    canvas.addEventListener('wheel', event => {
      event.preventDefault();
      const lines = event.deltaMode ? 30 : 1, [x, y] = at(event);
      camera.zoom(Math.exp(Math.max(-200, Math.min(200, event.deltaY * lines)) / 500),
                  2 * x / canvas.clientWidth - 1, 1 - 2 * y / canvas.clientHeight);
      viewer.move();
    }, { passive: false });
  }

  click(x, y) {
    const line = this.viewer.pick(x, y);
    this.light(line < 0 ? -1 : scene.lines[line].row, false);
  }

  listenToKeys() {
    const { camera } = this.viewer;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const actions = {
      '+': () => camera.zoom(0.85), '=': () => camera.zoom(0.85), '-': () => camera.zoom(1 / 0.85),
      '0': () => this.reset(), Home: () => this.reset(), Escape: () => this.light(-1, false),
      n: () => this.step(1), p: () => this.step(-1), s: () => this.save(),
      ',': () => camera.roll(0.1), '.': () => camera.roll(-0.1),
    };
    document.addEventListener('keydown', event => {
      const arrow = arrows[event.key], kind = event.target.type || '';
      if (event.ctrlKey || event.metaKey || event.altKey || /text|select/.test(kind) ||
          arrow && /range|radio/.test(kind))
        return;
      if (arrow && event.shiftKey)
        camera.pan(arrow[0] * 0.05, -arrow[1] * 0.05);
      else if (arrow)
        camera.turn(arrow[0] * 0.1, arrow[1] * 0.1);
      else if (actions[event.key])
        actions[event.key]();
      else
        return;
      event.preventDefault();
      this.viewer.move();
    });
  }
}

async function start() {
  const began = performance.now();
  const viewer = new Viewer(element('canvas'), scene);
  viewer.setLines(await loadLines(scene));
  const surfaces = [];
  for (const [i, surface] of scene.surfaces.entries())
    surfaces.push(await loadSurface(surface, `surface${i}`, viewer.size));
  surfaces.forEach(surface => viewer.addSurface(surface));
  viewer.camera.home.radius = Math.max(...surfaces.map(surface => surface.radius), 1e-3);
  viewer.camera.reset();
  const page = new Page(viewer);
  viewer.drawNow();
  window.htloops = { page, viewer, scene, loadMilliseconds: performance.now() - began };
  document.body.classList.add('ready');
}

start().catch(error => {
  element('message').textContent = `The surface cannot be drawn here: ${error.message}`;
  element('message').hidden = false;
  throw error;
});
