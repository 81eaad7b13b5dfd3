// The table: rows are sorted, hidden by a range and by what is searched for, lit, and chosen.

const element = id => document.getElementById(id);

const soon = () => new Promise(resolve => setTimeout(resolve));

// Hides or disables a control, or what holds some; the keyboard then goes on at the surface.
function withdraw(node, property, isAway) {
  const hadFocus = node.contains(document.activeElement);
  node[property] = isAway;
  if (isAway && hadFocus)
    element('canvas').focus({ preventScroll: true });
}

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

const comparisons = {
  '<': (a, b) => a < b, '>': (a, b) => a > b, '<=': (a, b) => a <= b, '>=': (a, b) => a >= b, '=': (a, b) => a === b,
};

class Table {
  // `show(index, isLookedAt)` is called for a row that is to be lit, `change()` when others are chosen or hidden.
  constructor(scene, show, change) {
    Object.assign(this, { scene, show, change, search: '', isColoured: false });
    this.rows = scene.rows.map((cells, index) => ({ cells, index, lines: [], chosen: false }));
    scene.lines.forEach((line, i) => this.rows[line.row]?.lines.push(i));
    this.scales = this.allScales();
    this.order = [...this.rows];
    this.chooseScale(0);
    this.makeHead();
    this.makeRows();
    element('table').hidden = this.rows.length === 0;
  }

  // Lengths, what the page brings along, and every other column of numbers.
  allScales() {
    const { scene } = this, scales = scene.lengths.length ? [{ name: 'length', values: scene.lengths }] : [];
    scales.push(...scene.scales);
    scene.columns.forEach(({ name, number }, i) => {
      const values = scene.rows.map(row => row[i] === '' ? null : Number(row[i].replace('%', '')));
      if (i > 0 && number && !scales.some(scale => scale.name === name) && values.some(Number.isFinite))
        scales.push({ name, values: values.map(x => Number.isFinite(x) ? x : null) });
    });
    return scales;
  }

  // By what rows are hidden. What is not known is shown as long as all is.
  chooseScale(number) {
    this.scale = this.scales[number] || { name: '', values: [] };
    this.values = this.scale.values;
    this.steps = [...new Set(this.values.filter(v => v !== null))].sort((a, b) => a - b);
    this.range = [0, this.steps.length - 1];
  }

  isInRange(row) {
    const value = this.values[row.index], [first, last] = this.range;
    if (value === null || value === undefined)
      return first === 0 && last === this.steps.length - 1;
    return value >= this.steps[first] && value <= this.steps[last];
  }

  // Words that occur in it, or comparisons with a column, and commas between these.
  isFound(row) {
    return this.search.toLowerCase().split(/,(?![^(]*\))/).map(term => term.trim()).every(term => {
      const [, name, sign, value] = (term.match(/^([^<>=]*)(<=|>=|<|>|=)(.*)$/) || []).map(text => text.trim());
      if (!sign)
        return row.cells.some(cell => cell.toLowerCase().includes(term));
      const cell = row.cells[this.columnOf(name)]?.toLowerCase(), [a, b] = [cell, value].map(Number.parseFloat);
      if (cell === undefined || value === '' || Number.isNaN(b) && sign !== '=')
        return true; // it is not finished
      return Number.isNaN(b) || Number.isNaN(a) ? sign === '=' && cell === value : comparisons[sign](a, b);
    });
  }

  columnOf(name) {
    const names = this.scene.columns.map(column => column.name.toLowerCase()), whole = names.indexOf(name);
    return whole >= 0 || name === '' ? whole : names.findIndex(other => other.startsWith(name));
  }

  isShown(row) {
    return this.isInRange(row) && this.isFound(row);
  }

  // Evenly over the values that there are; grey where none is known.
  colourOf(row) {
    const value = this.values[row.index], last = Math.max(1, this.steps.length - 1);
    return value === null || value === undefined ? [140, 140, 140] : tint(this.steps.indexOf(value) / last);
  }

  get chosen() {
    return this.rows.filter(row => row.chosen);
  }

  get shown() {
    return this.order.filter(row => !row.node.hidden);
  }

  // ---- what is on the page

  // Columns of long words are seen in the wide table, and beside a row that is lit.
  isLong(column) {
    return column > 0 && this.rows.some(row => row.cells[column].length > 12);
  }

  classOf(column) {
    return `${this.scene.columns[column].number ? 'n' : ''} ${this.isLong(column) ? 'long' : ''}`;
  }

  makeHead() {
    this.classes = this.scene.columns.map((_, i) => this.classOf(i));
    element('head').append(made('th', {}, made('span', { className: 'unseen', textContent: 'chosen' })));
    this.scene.columns.forEach((column, i) => {
      const title = column.about || `sort by ${column.name}`;
      const button = made('button', { type: 'button', textContent: column.name, title });
      button.onclick = () => this.sort(i);
      element('head').append(made('th', { className: this.classes[i], scope: 'col' }, button));
    });
  }

  makeRows() {
    for (const row of this.rows) {
      const canBeChosen = row.index in this.scene.numbers;
      const box = made('input', { type: 'checkbox', tabIndex: -1, hidden: !canBeChosen });
      box.setAttribute('aria-label', `choose ${row.cells[0]}`);
      box.onclick = event => event.stopPropagation();
      box.onchange = () => {
        row.chosen = box.checked;
        this.change();
      };
      row.box = box;
      row.node = made('tr', { row, tabIndex: row.index === 0 ? 0 : -1 }, made('td', {}, box));
      row.cells.forEach((cell, i) => row.node.append(made('td', { className: this.classes[i], textContent: cell })));
      row.node.onclick = () => this.show(row.index, true);
      row.node.onkeydown = event => this.listen(event, row);
    }
    element('rows').append(...this.rows.map(row => row.node));
    const { scrollWidth, clientWidth } = element('table');
    element('wide').hidden = scrollWidth <= clientWidth && !this.classes.some(name => name.includes('long'));
  }

  listen(event, row) {
    const { shown } = this, at = shown.indexOf(row);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: shown.length - 1 }[event.key];
    if (to !== undefined) {
      const next = shown[to];
      if (next)
        this.focus(next);
    } else if (event.key === 'Enter' && event.target === row.node) {
      this.show(row.index, true);
    } else if (event.key === ' ' && !row.box.hidden && event.target === row.node) {
      row.box.click();
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  // Of all rows one is reached by the tabulator.
  focus(row) {
    this.rows.forEach(({ node }) => { node.tabIndex = -1; });
    row.node.tabIndex = 0;
    row.node.focus();
  }

  sort(column) {
    this.descending = this.sorted === column && !this.descending;
    this.sorted = column;
    const sign = this.descending ? -1 : 1, { number } = this.scene.columns[column];
    const value = row => number ? parseFloat(row.cells[column]) || 0 : sizeIn(row.cells[column]);
    const order = (a, b) => value(a) - value(b) || a.cells[column].localeCompare(b.cells[column]);
    this.order = [...this.rows].sort((a, b) => sign * order(a, b) || a.index - b.index);
    element('rows').append(...this.order.map(row => row.node));
    [...element('head').children].forEach((node, i) => i > 0 && node.setAttribute(
      'aria-sort', i !== column + 1 ? 'none' : this.descending ? 'descending' : 'ascending'));
  }

  // The row that is lit is shown, whatever hides others.
  refresh(lit) {
    const hadFocus = element('rows').contains(document.activeElement);
    for (const row of this.rows) {
      row.node.hidden = !this.isShown(row) && row.index !== lit;
      row.node.classList.toggle('lit', row.index === lit);
      row.node.setAttribute('aria-selected', row.index === lit);
    }
    const { shown } = this;
    if (shown.length === 0 || shown.some(({ node }) => node.tabIndex === 0))
      return;
    if (hadFocus)
      this.focus(shown[0]);
    else
      shown[0].node.tabIndex = 0;
  }

  // What is told of a row, with names: the first words stand for it.
  namesAndCells(row) {
    return this.scene.columns.map(({ name }, i) => [name, row.cells[i]]).filter(([, cell]) => cell !== '');
  }
}
