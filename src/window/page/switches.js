// The switches of the view, and what colours mean.

// The direction of an axis by its name, such as -x.
const axisNamed = name => [...'xyz'].map(axis => name.endsWith(axis) ? (name[0] === '-' ? -1 : 1) : 0);

class Switches {
  constructor(page) {
    this.page = page;
    this.viewer = page.viewer;
    this.makeLegend();
    this.listen();
    this.makeButtons();
    this.makeBalls();
    element('thickness').hidden = !scene.lines.some(line => line.radii);
    this.refresh();
  }

  makeLegend() {
    const mark = (colour, name = 'mark') => {
      const node = made('span', { className: name });
      node.style.background = `rgb(${colour})`;
      return node;
    };
    scene.groups.forEach((group, i) => {
      if (!scene.lines.some(line => line.group === i))
        return;
      const box = made('input', { type: 'checkbox', checked: true, id: `group${i}` });
      box.onchange = () => {
        this.page.groupsShown[i] = box.checked;
        this.page.refresh();
      };
      element('legend').append(made('label', {}, box, mark(group.colour), group.name));
    });
    element('legend').append(...scene.patches.map(
      ({ name, colour }) => made('label', {}, mark(colour, 'mark patch'), name)));
    if (scene.surfaces.length > 1)
      scene.surfaces.forEach((surface, i) => this.addChoiceOf(surface, i));
  }

  addChoiceOf(surface, i) {
    const radio = made('input', { type: 'radio', name: 'surface', checked: i === 0, id: `show${i}` });
    radio.onchange = () => {
      this.viewer.shown = i;
      this.page.refresh();
    };
    element('legend').append(made('label', {}, radio, surface.name));
  }

  listen() {
    const { viewer } = this, { camera } = viewer, change = (id, event, action) => {
      element(id)[event] = () => {
        action(element(id));
        this.refresh();
        viewer.stir();
      };
    };
    change('opacity', 'oninput', node => { viewer.opacity = node.value / 100; });
    change('cut', 'oninput', node => { viewer.cut.part = node.value / 1000; });
    change('axis', 'onchange', node => { viewer.cut.direction = node.value; });
    change('wire', 'onchange', node => { viewer.isWired = node.checked; });
    change('thick', 'onchange', node => { viewer.isThick = node.checked; });
    change('open', 'onchange', node => { camera.front = node.checked ? this.frontOfLit() : Camera.everything; });
    change('up', 'onchange', node => {
      const before = camera.home.up;
      camera.home.up = node.value ? axisNamed(node.value) : scene.up;
      const pose = camera.poseFrom(camera.back, camera.place, camera.distance, camera.front);
      camera.home.up = before;
      viewer.flyTo(pose);
    });
  }

  // What of the space before the lit lines stays.
  frontOfLit() {
    const { camera } = this.viewer, { lines } = this.page.table.rows[this.page.lit];
    const heights = lines.flatMap(i => this.viewer.pointsOfLine(scene.lines[i]))
      .map(p => dot(difference(p, camera.place), camera.back));
    return heights.length > 0 ? Math.max(1.1 * Math.max(...heights), 1e-3) : Camera.everything;
  }

  makeButtons() {
    const { viewer, page } = this, toggle = (id, name, attribute, isReversed = false) => {
      element(id).onclick = () => {
        const isOn = document.body.classList.toggle(name);
        element(id).setAttribute(attribute, isOn !== isReversed);
        viewer.draw();
      };
    };
    toggle('panel', 'alone', 'aria-expanded', true);
    element('panel').addEventListener('click', () => {
      if (element('side').contains(document.activeElement))
        element('panel').focus();
    });
    toggle('sheet', 'open', 'aria-expanded');
    element('sheet').hidden = page.table.rows.length === 0 && scene.empty === '';
    toggle('wide', 'wide', 'aria-pressed');
    element('full').hidden = !document.fullscreenEnabled;
    element('full').onclick = () => this.fillScreen();
    element('reset').onclick = () => page.reset();
    element('back').onclick = () => viewer.goBack();
    element('measure').onclick = () => page.toggleMeasuring();
    document.querySelectorAll('.menu').forEach(menu => { // of which one is open
      menu.ontoggle = () => document.querySelectorAll('.menu[open]').forEach(other => {
        other.open = other === menu || !menu.open;
      });
      menu.addEventListener('focusout', event => {
        menu.open = menu.open && (!event.relatedTarget || menu.contains(event.relatedTarget));
      });
    });
  }

  fillScreen() {
    if (document.fullscreenElement)
      document.exitFullscreen();
    else
      document.documentElement.requestFullscreen()
        .catch(() => this.page.say('This browser does not allow full screen.', true));
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

  reset() {
    const { viewer } = this, { shown } = viewer;
    viewer.setDefaults(scene);
    viewer.shown = shown;
    viewer.camera.home.up = scene.up;
    this.page.groupsShown.fill(true);
    document.querySelectorAll('#legend input[type=checkbox]').forEach(box => { box.checked = true; });
    if (Number(element('ball').value) > 0) {
      element('ball').value = 0;
      element('ball').oninput();
    }
    this.refresh();
  }

  refresh() {
    const { opacity, cut, isWired, isThick } = this.viewer, percent = part => `${Math.round(100 * part)}%`;
    element('opacity').value = 100 * opacity;
    element('opacity').nextElementSibling.textContent = percent(opacity);
    element('cut').value = 1000 * cut.part;
    element('cut').nextElementSibling.textContent = cut.part >= 1 ? 'all' : percent(cut.part);
    element('axis').value = cut.direction;
    element('wire').checked = isWired;
    element('thick').checked = isThick;
  }

  // What depends on where the eye is.
  refreshForView() {
    const { up } = this.viewer.camera.home, names = [...element('up').options].map(option => option.value);
    const isUp = name => name !== '' && String(axisNamed(name)) === String(up);
    element('up').value = up === scene.up ? '' : names.find(isUp) ?? '';
    withdraw(element('back'), 'disabled', !this.viewer.canGoBack);
    element('open').checked = this.viewer.camera.isCutOpen;
    element('open').disabled = this.page.lit < 0;
  }
}
