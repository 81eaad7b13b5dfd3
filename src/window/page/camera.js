// An eye that turns about a place. The unit is half the diagonal of the box, its middle the origin.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, s) => a.map(x => x * s);
const sum = (a, b) => a.map((x, i) => x + b[i]);
const difference = (a, b) => a.map((x, i) => x - b[i]);
const normalized = a => scaled(a, 1 / (Math.hypot(...a) || 1));
const clamped = (x, low, high) => Math.min(Math.max(x, low), high);

// A direction at a right angle to another one.
const anyAcross = a => normalized(cross(a, Math.abs(a[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]));

// A direction on the way from one to another.
function turned(a, b, t) {
  const angle = Math.acos(clamped(dot(a, b), -1, 1)), aside = difference(b, scaled(a, dot(a, b)));
  const way = Math.hypot(...aside) > 1e-3 ? normalized(aside) : anyAcross(a);
  return sum(scaled(a, Math.cos(t * angle)), scaled(way, Math.sin(t * angle)));
}

// So many directions, spread evenly over the sphere.
function directions(count) {
  return Array.from({ length: count }, (_, i) => {
    const z = 1 - (2 * i + 1) / count, r = Math.sqrt(1 - z * z), angle = i * Math.PI * (3 - Math.sqrt(5));
    return [r * Math.cos(angle), r * Math.sin(angle), z];
  });
}

class Camera {
  static halfAngle = Math.tan(15 * Math.PI / 180); // of view, along the shorter side of the picture
  static everything = 4; // in front of the place, where nothing is cut away

  constructor(view, up) {
    this.home = { view, up, points: [] }; // which are to be seen
    this.aspect = 1;
    this.pose = this.homePose();
  }

  // Half the width and half the height of what is seen, at a distance of 1.
  get extent() {
    return [Math.max(1, this.aspect), Math.max(1, 1 / this.aspect)].map(s => s * Camera.halfAngle);
  }

  // Where the eye is; `front` is how much is seen in front of the place, the rest is cut away.
  get pose() {
    const { back, up, place, distance, front, home: { up: upright } } = this;
    return { back, up, place, distance, front, upright };
  }

  set pose({ back, up, place, distance, front, upright }) {
    const across = cross(up, back);
    this.home.up = upright;
    Object.assign(this, { back: normalized(back), place, distance, front });
    this.right = Math.hypot(...across) > 1e-6 ? normalized(across) : anyAcross(this.back);
    this.up = cross(this.back, this.right);
  }

  get isCutOpen() {
    return this.front < Camera.everything;
  }

  // So that the points fill the picture.
  homePose() {
    const { view, points } = this.home, { everything, halfAngle } = Camera;
    const pose = this.poseFrom(view, [0, 0, 0], 1.06 / halfAngle, everything, anyAcross(normalized(view)));
    if (points.length === 0)
      return pose;
    const right = normalized(cross(pose.up, pose.back)), up = cross(pose.back, right);
    const [x, y, z] = [right, up, pose.back].map(axis => points.map(p => dot(p, axis)));
    const [u, v, w] = [x, y, z].map(all => (Math.min(...all) + Math.max(...all)) / 2);
    const [width, height] = [0.92 * this.extent[0], 0.84 * this.extent[1]]; // tools stand over it
    const distance = points.reduce((most, _, i) => Math.max(
      most, z[i] - w + Math.max(Math.abs(x[i] - u) / width, Math.abs(y[i] - v) / height)), 1e-3);
    const place = sum(sum(scaled(right, u), scaled(up, v)), scaled(pose.back, w));
    return { ...pose, place, distance };
  }

  // Upright as far as that can be, else as `other`.
  poseFrom(view, place, distance, front = Camera.everything, other = this.up) {
    const back = normalized(view), { up: upright } = this.home;
    const isAcross = Math.abs(dot(back, normalized(upright))) < 0.999;
    return { back, up: isAcross ? upright : other, place, distance, front, upright };
  }

  // On the way between two poses.
  static between(from, to, t) {
    return { back: turned(from.back, to.back, t), up: turned(from.up, to.up, t),
             place: sum(from.place, scaled(difference(to.place, from.place), t)),
             distance: from.distance ** (1 - t) * to.distance ** t,
             front: t < 1 ? from.front ** (1 - t) * to.front ** t : to.front, upright: to.upright };
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
    const next = clamped(this.distance * factor, 1e-3, 50);
    const [width, height] = scaled(this.extent, this.distance - next);
    this.place = sum(this.place, sum(scaled(this.right, x * width), scaled(this.up, y * height)));
    this.distance = next;
  }

  // How far the eye is from a place around which so much is to be seen.
  static distanceFor(radius) {
    return clamped(radius * 2.5, 0.006, 1.05) / Camera.halfAngle;
  }

  // Where the eye is, and the direction in which it sees (x, y), from -1 to 1.
  ray(x, y) {
    const [width, height] = this.extent, eye = sum(this.place, scaled(this.back, this.distance));
    const aside = sum(scaled(this.right, x * width), scaled(this.up, y * height));
    return { eye, direction: normalized(difference(aside, this.back)) };
  }

  // From points to the picture, columns one after the other.
  matrix() {
    const [width, height] = this.extent, away = Math.hypot(...this.place);
    const near = Math.max(this.distance - Math.min(this.front, 1.1 + away), this.distance * 0.02);
    const far = this.distance + 1.2 + away;
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
