// From where loops are seen best, if what is in front of them is cut away.

const SIGHT_CELLS = 48; // of the small pictures, along each side

// A small picture of triangles from a direction: how near each place of it is to the eye.
class Sight {
  constructor(back, place, radius) {
    const right = anyAcross(back), cells = SIGHT_CELLS / 2 / radius;
    // To the right, upwards, and to the eye, in cells.
    this.axes = [right, cross(back, right), back].map(axis => scaled(axis, cells));
    this.shifts = this.axes.map((axis, k) => (k < 2 ? SIGHT_CELLS / 2 : 0) - dot(axis, place));
    this.depths = new Float32Array(SIGHT_CELLS ** 2).fill(-Infinity);
  }

  seen(p) {
    return this.axes.map((axis, k) => dot(axis, p) + this.shifts[k]);
  }

  // Triangles as `trianglesNear()` gives them, but for what is nearer than `front`.
  add(corners, front) {
    const { axes, shifts, depths } = this, p = new Float64Array(9);
    for (let i = 0; i < corners.length; i += 9) {
      for (let k = 0; k < 9; ++k) {
        const axis = axes[k / 3 | 0], c = i + k % 3;
        p[k] = axis[0] * corners[c] + axis[1] * corners[c + 3] + axis[2] * corners[c + 6] + shifts[k / 3 | 0];
      }
      this.addTriangle(p, depths, front);
    }
  }

  // Corners to the right, then upwards, then to the eye.
  addTriangle(p, depths, front) {
    const [a, b, c, d, e, f, g] = p, ux = b - a, uy = e - d, vx = c - a, vy = f - d, area = ux * vy - uy * vx;
    const left = Math.max(0, Math.round(Math.min(a, b, c))), below = Math.max(0, Math.round(Math.min(d, e, f)));
    const right = Math.min(SIGHT_CELLS, Math.round(Math.max(a, b, c)));
    const above = Math.min(SIGHT_CELLS, Math.round(Math.max(d, e, f)));
    for (let y = below; y < above && area !== 0; ++y)
      for (let x = left; x < right; ++x) {
        const u = x + 0.5 - a, v = y + 0.5 - d, s = (u * vy - v * vx) / area, t = (v * ux - u * uy) / area;
        const depth = g + s * (p[7] - g) + t * (p[8] - g), at = y * SIGHT_CELLS + x;
        if (s >= 0 && t >= 0 && s + t <= 1 && depth < front && depth > depths[at])
          depths[at] = depth;
      }
  }

  // How long what is seen of a line is in the picture.
  lengthSeen(line) {
    let length = 0, last = null;
    for (const p of line) {
      const [x, y, depth] = this.seen(p);
      const column = clamped(Math.floor(x), 0, SIGHT_CELLS - 1), row = clamped(Math.floor(y), 0, SIGHT_CELLS - 1);
      const isSeen = depth > this.depths[row * SIGHT_CELLS + column] - 2;
      if (isSeen && last)
        length += Math.hypot(x - last[0], y - last[1]);
      last = isSeen ? [x, y] : null;
    }
    return length;
  }
}

// Lines around a place; of directions that are about as good the one nearest to `usual`. Each line counts
// by the root of what is seen of it, so that it is better to see some of all.
function bestSight(surface, placing, lines, place, radius, front, usual) {
  const corners = trianglesNear(surface, placing, place, 1.3 * radius);
  let best = usual, most = -Infinity;
  for (const back of [usual, ...directions(32)]) {
    const sight = new Sight(back, place, 1.3 * radius);
    sight.add(corners, front * SIGHT_CELLS / 2.6 / radius);
    const seen = (1 + 0.15 * dot(back, usual)) *
                 lines.reduce((all, line) => all + Math.sqrt(sight.lengthSeen(line)), 0);
    if (seen > most)
      [most, best] = [seen, back];
  }
  return best;
}
