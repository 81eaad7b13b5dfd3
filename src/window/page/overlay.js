// What is written over the surface: axes, a scale, and a distance that is measured.

// About three digits, as a person would write them.
function words(number) {
  const size = Math.abs(number);
  if (number === 0 || !Number.isFinite(number))
    return String(number);
  return size >= 1e6 || size < 1e-4 ? number.toExponential(2) : String(Number(number.toPrecision(4)));
}

class Overlay {
  constructor(viewer, scene) {
    this.viewer = viewer;
    this.canvas = document.getElementById('over');
    this.pen = this.canvas.getContext('2d');
    this.unit = scene.unit ? ` ${scene.unit}` : '';
    this.ends = []; // of what is measured
    viewer.listeners.push(() => this.draw());
  }

  get lengthMeasured() {
    return this.ends.length === 2 ? Math.hypot(...difference(...this.ends)) * this.viewer.length : null;
  }

  wordsOf(length) {
    return words(length) + this.unit;
  }

  draw() {
    const { canvas, pen } = this, ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    pen.scale(ratio, ratio);
    if (!this.viewer.isReady)
      return;
    const style = getComputedStyle(canvas.parentElement);
    Object.assign(this, { width, height, ink: style.color, paper: style.backgroundColor });
    pen.font = '12px system-ui, sans-serif';
    this.drawAxes();
    this.drawScale();
    this.drawMeasure();
  }

  line(points, colour, width) {
    const { pen } = this;
    for (const [style, extra] of [[this.paper, 3], [colour, 0]]) {
      Object.assign(pen, { strokeStyle: style, lineWidth: width + extra, lineCap: 'round' });
      pen.beginPath();
      points.forEach(([x, y]) => pen.lineTo(x, y));
      pen.stroke();
    }
  }

  text(text, x, y, align = 'center', colour = this.ink) {
    Object.assign(this.pen, { textAlign: align, textBaseline: 'middle', strokeStyle: this.paper, fillStyle: colour,
                              lineWidth: 4, lineJoin: 'round' });
    this.pen.strokeText(text, x, y);
    this.pen.fillText(text, x, y);
  }

  drawAxes() {
    const { right, up, back } = this.viewer.camera, x = 44, y = this.height - 44, length = 26;
    const colours = ['#c0392b', '#2e8b57', '#2b6cc4'];
    const axes = [0, 1, 2].map(
      k => ({ name: 'xyz'[k], colour: colours[k], depth: back[k], aside: [right[k], -up[k]] }));
    for (const { name, colour, aside: [u, v] } of axes.sort((a, b) => a.depth - b.depth)) {
      this.line([[x, y], [x + length * u, y + length * v]], colour, 2.5);
      this.text(name, x + (length + 9) * u, y + (length + 9) * v, 'center', colour);
    }
  }

  // A round number of units, at the depth of the place that is looked at.
  drawScale() {
    const { camera, length } = this.viewer, pixels = this.height / 2 / camera.extent[1] / camera.distance / length;
    if (!(pixels > 0 && Number.isFinite(pixels)))
      return;
    const most = Math.min(140, this.width / 4) / pixels, power = 10 ** Math.floor(Math.log10(most));
    const size = power * [5, 2, 1].find(factor => factor * power <= most);
    const right = this.width - 20, left = right - size * pixels, y = this.height - 20;
    this.line([[left, y - 4], [left, y], [right, y], [right, y - 4]], this.ink, 1.5);
    this.text(this.wordsOf(size), (left + right) / 2, y - 12);
  }

  drawMeasure() {
    const places = this.ends.map(end => this.viewer.project(end)).filter(Boolean);
    if (places.length === 2)
      this.line(places, this.ink, 2);
    for (const place of places)
      this.line([place, place], this.ink, 7);
    if (places.length === 2)
      this.text(this.wordsOf(this.lengthMeasured), (places[0][0] + places[1][0]) / 2,
                (places[0][1] + places[1][1]) / 2 - 14);
  }
}
