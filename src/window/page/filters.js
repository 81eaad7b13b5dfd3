// Which rows are shown: what is searched for, and the range of a number.

class Filters {
  constructor(page) {
    this.page = page;
    this.table = page.table;
    this.ends = ['shortest', 'longest'];
    this.listen();
    element('filters').hidden = this.table.rows.length === 0;
    this.refresh();
  }

  listen() {
    const { table, page } = this, choice = element('scale'), box = element('colours').querySelector('input');
    choice.append(...table.scales.map(({ name }, i) => made('option', { value: i, textContent: name })));
    choice.onchange = () => this.change(() => table.chooseScale(Number(choice.value)));
    box.onchange = () => this.change(() => { table.isColoured = box.checked; });
    element('search').oninput = () => {
      table.search = element('search').value;
      page.refresh();
    };
    this.ends.forEach((id, end) => {
      element(id).oninput = () => this.setEnd(end, Number(element(id).value));
      element(`${id}-value`).onchange = event => this.setEnd(end, this.stepFor(end, event.target.value));
    });
  }

  change(action) {
    action();
    this.refresh();
    this.page.refresh();
  }

  // The first value that is not below a number, or the last one that is not above it; all for no number.
  stepFor(end, text) {
    const { steps } = this.table, last = steps.length - 1, value = Number(text);
    if (text === '')
      return end * last;
    if (end === 1)
      return Math.max(0, steps.filter(x => x <= value).length - 1);
    const first = steps.findIndex(x => x >= value);
    return first < 0 ? last : first;
  }

  setEnd(end, step) {
    const { range } = this.table;
    this.change(() => {
      range[end] = step;
      if (range[0] > range[1])
        range[1 - end] = step;
    });
  }

  reset() {
    const { table } = this;
    Object.assign(table, { search: '', isColoured: false });
    element('search').value = '';
    element('scale').selectedIndex = 0;
    table.chooseScale(0);
    this.refresh();
  }

  refresh() {
    const { steps, range, scale, isColoured } = this.table, last = steps.length - 1, isLength = scale.name === 'length';
    const extremes = isLength ? ['shortest', 'longest'] : ['smallest', 'largest'];
    this.ends.forEach((id, end) => {
      const text = `${extremes[end]} ${isLength ? scene.noun : scale.name} shown`, disabled = last < 1;
      const value = last < 0 ? '' : Number(steps[range[end]].toPrecision(5));
      element(`${id}-words`).textContent = text;
      Object.assign(element(id), { min: 0, max: Math.max(0, last), value: range[end], disabled });
      Object.assign(element(`${id}-value`), { value, disabled });
      element(`${id}-value`).setAttribute('aria-label', text);
    });
    element('colours').querySelector('input').checked = isColoured;
    this.refreshGradient(isColoured && last >= 0);
  }

  refreshGradient(isSeen) {
    const { steps } = this.table, gradient = element('gradient');
    gradient.hidden = !isSeen;
    if (isSeen) {
      gradient.firstElementChild.textContent = words(steps[0]);
      gradient.lastElementChild.textContent = words(steps[steps.length - 1]);
    }
  }
}
