// What is seen, and from where. Without a renderer all of it works, and nothing is drawn.

class Viewer {
  constructor(canvas, scene) {
    this.canvas = canvas;
    this.size = scaled(scene.size, 2 / (Math.hypot(...scene.size) || 1));
    this.placing = new Placing(this.size);
    this.camera = new Camera(scene.view, scene.up);
    this.length = scene.extent / Math.max(...this.size) || 0; // of the unit in which the page counts
    this.surfaces = [];
    this.hasBones = scene.bones;
    this.lineWidth = 4;
    this.background = [1, 1, 1];
    this.listeners = [];
    this.poses = []; // to which one can go back
    this.costs = { frame: 0, triangle: 0 }; // milliseconds, as far as they are known
    this.setDefaults(scene);
  }

  setDefaults(scene) {
    this.shown = 0;
    this.opacity = scene.opacity;
    this.isWired = false;
    this.isThick = false; // lines that have radii
    this.cut = { direction: 'x', part: 1 };
  }

  // ---- what is drawn

  // Draws with the renderer from now on; after a loss of the graphics card with another one.
  setRenderer(renderer) {
    this.renderer = renderer;
    this.refining = null;
    if (this.linePoints)
      renderer.setLines(this.linePoints);
    this.surfaces.forEach(surface => renderer.addSurface(surface));
  }

  addSurface(surface) {
    this.surfaces.push(surface);
    this.renderer?.addSurface(surface);
  }

  setLines(points) {
    this.linePoints = points;
    this.renderer?.setLines(points);
  }

  fillParts(number, colours) {
    this.renderer?.fill(this.renderer.surfaces[number].palette, colours);
    this.stir();
  }

  fillLines(colours) {
    this.renderer?.lines.fill(colours);
    this.stir();
  }

  // By steps from where its points were.
  shiftLine(line, home, shift) {
    for (let i = line.first; i <= line.last; ++i)
      for (let k = 0; k < 3; ++k) {
        const place = clamped(Math.round(stepsOf(home, i, k) + shift[k]), 0, STEPS);
        this.linePoints[4 * i + k] = home[4 * i + k] - stepsOf(home, i, k) + place;
      }
  }

  refillLines() {
    this.renderer?.setLines(this.linePoints);
    this.stir();
  }

  pointOfLine(i) {
    return [0, 1, 2].map(k => stepsOf(this.linePoints, i, k) * this.placing.scale[k] + this.placing.shift[k]);
  }

  pointsOfLine({ first, last }) {
    return Array.from({ length: last - first + 1 }, (_, i) => this.pointOfLine(first + i));
  }

  // Of a plane; what lies beyond is not drawn.
  cutPlane() {
    const { direction, part } = this.cut;
    if (part >= 1)
      return [0, 0, 0, 1];
    const normal = this.normalOfCut(direction);
    const half = direction === 'eye' ? 1 : normal.reduce((all, x, k) => all + Math.abs(x) * this.size[k] / 2, 0);
    return [...normal, half * (2 * part - 1)];
  }

  normalOfCut(direction) {
    if (direction === 'eye')
      return this.camera.back;
    if (direction === 'loop')
      return this.normalOfLoop || this.camera.back;
    const sign = direction[0] === '-' ? -1 : 1;
    return [...'xyz'].map(axis => direction.endsWith(axis) ? sign : 0);
  }

  // ---- frames

  // Pixels of the canvas' own, from the upper left, or null behind the eye.
  project(place) {
    const { columns: m } = this.camera.matrix();
    const [x, y, , w] = [0, 1, 2, 3].map(r => m[r] * place[0] + m[4 + r] * place[1] + m[8 + r] * place[2] + m[12 + r]);
    return w > 0 ? [(x / w + 1) / 2 * this.canvas.clientWidth, (1 - y / w) / 2 * this.canvas.clientHeight] : null;
  }

  // What is below a pixel of the canvas' own: the point of the surface, or null.
  placeAt(x, y) {
    const { clientWidth, clientHeight } = this.canvas, { camera, placing } = this, [a, b, c, d] = this.cutPlane();
    const { eye, direction } = camera.ray(2 * x / clientWidth - 1, 1 - 2 * y / clientHeight);
    const nearest = camera.place.map((p, k) => p + camera.front * camera.back[k]);
    const isHidden = p => a * p[0] + b * p[1] + c * p[2] > d || dot(difference(p, nearest), camera.back) > 0;
    return this.surfaces[this.shown] ? firstOn(this.surfaces[this.shown], placing, eye, direction, isHidden) : null;
  }

  // Soon, and once, however often it is asked for.
  draw() {
    if (!this.isDue)
      requestAnimationFrame(() => {
        this.isDue = false;
        this.drawNow();
      });
    this.isDue = true;
  }

  get isReady() {
    return this.renderer?.lines && this.surfaces.length > 0 && !this.renderer.gl.isContextLost();
  }

  drawNow() {
    const { clientWidth, clientHeight } = this.canvas;
    this.camera.aspect = Math.max(1, clientWidth) / Math.max(1, clientHeight);
    if (this.isAtHome)
      this.camera.pose = this.camera.homePose();
    this.lineNumbers = null;
    if (this.isReady)
      this.paint(clientWidth, clientHeight);
    this.listeners.forEach(listener => listener());
  }

  paint(clientWidth, clientHeight) {
    const pixelRatio = window.devicePixelRatio || 1, { renderer } = this;
    const [width, height] = [clientWidth, clientHeight].map(x => Math.max(1, Math.round(x * pixelRatio)));
    if (this.canvas.width !== width || this.canvas.height !== height)
      Object.assign(this.canvas, { width, height });
    const triangles = renderer.prepare(this), time = this.timeFor(triangles);
    const show = detail => renderer.show(this, [...this.background, 1], detail, pixelRatio);
    this.refining = null;
    if (this.isMoving && time > 60)
      return finish(show(DETAIL.moving));
    if (time > 250) {
      finish(show(DETAIL.plain));
      return this.refine(show(DETAIL.smooth), triangles);
    }
    const began = performance.now();
    finish(show(DETAIL.smooth));
    renderer.wait();
    this.learnCosts(triangles, performance.now() - began);
  }

  // The steps of a picture, one by one, unless there is something else to draw.
  async refine(steps, triangles) {
    this.refining = steps;
    await this.renderer.drawn();
    const began = performance.now();
    while (this.refining === steps && this.isReady && !steps.next().done)
      await this.renderer.drawn();
    if (this.refining !== steps)
      return;
    this.refining = null;
    if (this.isReady)
      this.learnCosts(triangles, performance.now() - began);
  }

  // Before the renderer draws something else.
  stopRefining() {
    if (this.refining)
      this.draw();
    this.refining = null;
  }

  // Whether the processor is better left alone.
  get isBusy() {
    return Boolean(this.flight || this.isMoving || this.isDue || this.refining);
  }

  timeFor(triangles) {
    return this.costs.frame + triangles * this.costs.triangle;
  }

  learnCosts(triangles, time) {
    const { costs } = this;
    if (triangles < 5e4)
      costs.frame = time;
    else
      costs.triangle = Math.max(0, time - costs.frame) / triangles;
  }

  // The eye was moved.
  move() {
    this.isAtHome = false;
    this.stir();
  }

  // Soon again, with less if that takes long, and in full when it has come to rest.
  stir() {
    this.isMoving = true;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.isMoving = false;
      this.draw();
    }, 250);
    this.draw();
  }

  // When nothing moves any more, and all is drawn.
  async settled() {
    while (this.isBusy || this.isLightDue)
      await new Promise(resolve => setTimeout(resolve, 10));
  }

  // ---- flights

  // To a pose, in half a second, or at once if little is to move.
  fly(pose, done = () => {}) {
    const { pose: from } = this.camera, began = performance.now(), flight = this.flight = { pose };
    const duration = matchMedia('(prefers-reduced-motion: reduce)').matches || !this.isReady ? 0 : 500;
    const step = () => {
      if (this.flight !== flight)
        return; // another one began, or somebody turned the surface
      const t = duration ? Math.min(1, (performance.now() - began) / duration) : 1;
      this.camera.pose = t < 1 ? Camera.between(from, pose, t * t * (3 - 2 * t)) : pose;
      if (t < 1) {
        this.move();
        requestAnimationFrame(step);
      } else {
        clearTimeout(this.rest); // what was due at rest is drawn now
        this.flight = null;
        this.isMoving = this.isAtHome = false;
        done();
        this.draw();
      }
    };
    step();
  }

  stopFlight() {
    this.flight = null;
  }

  flyTo(pose) {
    const from = this.flight ? this.flight.pose : { ...this.camera.pose, isAtHome: this.isAtHome };
    this.poses = [...this.poses.slice(-49), from];
    this.fly(pose);
  }

  get canGoBack() {
    return this.poses.length > 0;
  }

  goBack() {
    if (!this.canGoBack)
      return;
    const pose = this.poses.pop();
    this.fly(pose, () => { this.isAtHome = pose.isAtHome || false; });
  }

  goHome() {
    this.poses = [];
    this.fly(this.camera.homePose(), () => { this.isAtHome = true; });
  }

  // Looks at lines: from `view`, where they are seen from outside, if there is such a direction; else with
  // what is in front of them cut away.
  lookAt(lines, view) {
    const places = lines.flatMap(line => this.pointsOfLine(line)), { camera, placing } = this;
    if (places.length === 0)
      return;
    const low = [0, 1, 2].map(i => places.reduce((m, p) => Math.min(m, p[i]), Infinity));
    const high = [0, 1, 2].map(i => places.reduce((m, p) => Math.max(m, p[i]), -Infinity));
    const place = scaled(sum(low, high), .5), radius = Math.max(1e-4, Math.hypot(...difference(high, low)) / 2);
    const distance = Camera.distanceFor(radius), front = 1.25 * radius;
    const surface = this.surfaces[this.shown];
    if (view || !surface || this.hasBones)
      this.flyTo(camera.poseFrom(view || camera.back, place, distance));
    else
      this.flyTo(camera.poseFrom(
        bestSight(surface, placing, lines.map(line => this.pointsOfLine(line)), place, radius, front, camera.back),
        place, distance, front));
  }

  // ---- what is pointed at

  // The line at a pixel of the canvas: one that is seen, else one behind the surface, else -1.
  pick(x, y) {
    if (!this.isReady)
      return -1;
    const { clientWidth: width, clientHeight: height } = this.canvas, reach = 6;
    const isCoarse = this.timeFor(this.renderer.prepare(this)) > 300;
    if (!this.lineNumbers)
      this.stopRefining();
    this.lineNumbers ||= this.renderer.numbers(this, width, height, isCoarse);
    let found = -1, nearest = Infinity;
    for (let v = Math.max(0, Math.round(y) - reach); v <= Math.min(height - 1, Math.round(y) + reach); ++v)
      for (let u = Math.max(0, Math.round(x) - reach); u <= Math.min(width - 1, Math.round(x) + reach); ++u) {
        const i = 4 * ((height - 1 - v) * width + u), n = this.lineNumbers;
        const number = n[i] + 256 * n[i + 1] + 65536 * n[i + 2];
        const distance = Math.hypot(u - x, v - y) + (n[i + 3] < 255 ? 2 * reach : 0);
        if (number > 0 && distance < nearest)
          [found, nearest] = [number - 1, distance];
      }
    return found;
  }
}
