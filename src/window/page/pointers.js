// What the mouse, fingers and keys do.

class Pointers {
  constructor(page) {
    this.page = page;
    this.viewer = page.viewer;
    this.canvas = page.viewer.canvas;
    this.pointers = new Map();
    this.listenToPointers();
    this.listenToKeys();
  }

  listenToPointers() {
    const { canvas, pointers, viewer } = this, at = event => [event.offsetX, event.offsetY];
    canvas.onpointerdown = event => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, at(event));
      this.moved = pointers.size > 1 ? Infinity : 0;
      canvas.focus({ preventScroll: true });
      this.page.closeMenus();
      element('hint').hidden = true; // who turns it knows how
    };
    canvas.onpointermove = event => {
      const before = pointers.get(event.pointerId);
      if (before)
        this.drag(event, before, at(event));
      else if (event.pointerType === 'mouse')
        this.hover(...at(event));
    };
    canvas.onpointerup = event => {
      pointers.delete(event.pointerId);
      if (this.moved < 5 && event.button === 0)
        this.click(event.timeStamp, ...at(event));
    };
    canvas.onpointercancel = event => pointers.delete(event.pointerId);
    canvas.onpointerleave = () => this.hover();
    canvas.ondblclick = event => this.pivot(...at(event));
    canvas.oncontextmenu = event => event.preventDefault();
    canvas.addEventListener('wheel', event => {
      event.preventDefault();
      const lines = event.deltaMode ? 30 : 1, [x, y] = at(event);
      viewer.stopFlight();
      viewer.camera.zoom(Math.exp(clamped(event.deltaY * lines, -200, 200) / 500),
                         2 * x / canvas.clientWidth - 1, 1 - 2 * y / canvas.clientHeight);
      viewer.move();
    }, { passive: false });
  }

  drag(event, before, now) {
    const { pointers, viewer, canvas } = this, { camera } = viewer, height = canvas.clientHeight;
    const [dx, dy] = difference(now, before);
    this.moved += Math.hypot(dx, dy);
    const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
    pointers.set(event.pointerId, now);
    viewer.stopFlight();
    this.hover();
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
  }

  // When the mouse rests: to see what it points at takes a picture.
  hover(x, y) {
    clearTimeout(this.resting);
    this.page.showTip(-1);
    if (x !== undefined)
      this.resting = setTimeout(() => this.page.showTip(this.viewer.isMoving ? -1 : this.viewer.pick(x, y), x, y), 60);
  }

  // The second one of a double click is no other one.
  click(time, x, y) {
    const { last } = this, isSecond = last && time - last.time < 400 && Math.hypot(x - last.x, y - last.y) < 6;
    this.last = { time, x, y };
    if (isSecond)
      return;
    this.litBefore = this.page.lit;
    this.page.click(x, y);
  }

  // What was pointed at comes to the middle, and all turns about it. The row that was lit stays so.
  pivot(x, y) {
    const { viewer } = this, place = viewer.placeAt(x, y), { camera } = viewer;
    if (!place || this.page.isMeasuring)
      return;
    this.page.light(this.litBefore, false);
    const nearer = dot(difference(place, camera.place), camera.back);
    viewer.flyTo({ ...camera.pose, place, distance: Math.max(0.05, camera.distance - nearer) });
  }

  listenToKeys() {
    const { page, viewer } = this, { camera } = viewer;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const motions = {
      '+': () => camera.zoom(0.85), '=': () => camera.zoom(0.85), '-': () => camera.zoom(1 / 0.85),
      ',': () => camera.roll(0.1), '.': () => camera.roll(-0.1),
    };
    const actions = {
      '0': () => page.reset(), Home: () => page.reset(), Escape: () => page.escape(), Backspace: () => viewer.goBack(),
      n: () => page.step(1), p: () => page.step(-1), s: () => page.saving.save(), m: () => element('measure').click(),
      f: () => element('full').click(), t: () => element('panel').click(), w: () => element('wire').click(),
    };
    document.addEventListener('keydown', event => {
      const arrow = arrows[event.key], kind = event.target.type || '';
      const isWriting = /text|search|number|select/.test(kind), isStep = arrow || event.key === 'Home';
      if (event.ctrlKey || event.metaKey || event.altKey || isWriting || isStep && /range|radio/.test(kind))
        return;
      if (actions[event.key]) {
        actions[event.key]();
      } else if (arrow || motions[event.key]) {
        viewer.stopFlight();
        if (!arrow)
          motions[event.key]();
        else if (event.shiftKey)
          camera.pan(arrow[0] * 0.05, -arrow[1] * 0.05);
        else
          camera.turn(arrow[0] * 0.1, arrow[1] * 0.1);
        viewer.move();
      } else {
        return;
      }
      event.preventDefault();
    });
  }
}
