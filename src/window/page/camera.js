// An eye that turns about a place. The unit is half the diagonal of the box, its middle the origin.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, s) => a.map(x => x * s);
const sum = (a, b) => a.map((x, i) => x + b[i]);
const difference = (a, b) => a.map((x, i) => x - b[i]);
const normalized = a => scaled(a, 1 / (Math.hypot(...a) || 1));

class Camera {
  static halfAngle = Math.tan(15 * Math.PI / 180); // of view, along the shorter side of the picture

  constructor(view, up) {
    this.home = { view, up, radius: 1 };
    this.aspect = 1;
    this.reset();
  }

  // Half the width and half the height of what is seen, at a distance of 1.
  get extent() {
    return [Math.max(1, this.aspect), Math.max(1, 1 / this.aspect)].map(s => s * Camera.halfAngle);
  }

  reset() {
    this.back = normalized(this.home.view); // from the place to the eye
    this.right = normalized(cross(this.home.up, this.back));
    this.up = cross(this.back, this.right);
    this.place = [0, 0, 0];
    this.distance = 1.06 * this.home.radius / Camera.halfAngle;
  }

  // By angles: about the upright axis of the picture, and about the one to the right.
  turn(across, along) {
    const rotate = (a, b, angle) => [sum(scaled(a, Math.cos(angle)), scaled(b, Math.sin(angle))),
                                     difference(scaled(b, Math.cos(angle)), scaled(a, Math.sin(angle)))];
    [this.back, this.right] = rotate(this.back, this.right, -across);
    [this.back, this.up] = rotate(this.back, this.up, along);
    this.back = normalized(this.back);
    this.right = normalized(cross(this.up, this.back));
    this.up = cross(this.back, this.right);
  }

  // About the axis to the eye.
  roll(angle) {
    const right = sum(scaled(this.right, Math.cos(angle)), scaled(this.up, Math.sin(angle)));
    this.right = normalized(right);
    this.up = cross(this.back, this.right);
  }

  // By parts of the height of the picture.
  pan(x, y) {
    const height = 2 * this.distance * this.extent[1];
    this.place = difference(this.place, sum(scaled(this.right, x * height), scaled(this.up, y * height)));
  }

  // What is at (x, y), from -1 to 1, stays there.
  zoom(factor, x = 0, y = 0) {
    const next = Math.min(Math.max(this.distance * factor, 1e-3), 50);
    const [width, height] = scaled(this.extent, this.distance - next);
    this.place = sum(this.place, sum(scaled(this.right, x * width), scaled(this.up, y * height)));
    this.distance = next;
  }

  lookAt(place, radius) {
    this.place = place;
    this.distance = Math.min(Math.max(radius * 2.5, 0.02), 1.05) / Camera.halfAngle;
  }

  // Turns about the place, to where the eye is in a direction; upright as far as that can be.
  lookFrom(back) {
    const across = cross(this.home.up, back);
    this.back = back;
    this.right = normalized(Math.hypot(...across) > 1e-3 ? across : cross(back, this.home.view));
    this.up = cross(this.back, this.right);
  }

  // From points to the picture, columns one after the other.
  matrix() {
    const [width, height] = this.extent;
    const near = Math.max(this.distance - 1.1 - Math.hypot(...this.place), this.distance * 0.02);
    const far = this.distance + 1.2 + Math.hypot(...this.place);
    const eye = sum(this.place, scaled(this.back, this.distance));
    const m = [];
    const depth = (far + near) / (far - near), offset = 2 * far * near / (far - near);
    for (let i = 0; i < 3; ++i)
      m.push(this.right[i] / width, this.up[i] / height, -this.back[i] * depth, -this.back[i]);
    m.push(-dot(this.right, eye) / width, -dot(this.up, eye) / height,
           dot(this.back, eye) * depth - offset, dot(this.back, eye));
    return { columns: new Float32Array(m), eye, near, depth, offset };
  }
}
