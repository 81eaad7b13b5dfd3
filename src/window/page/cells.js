// The triangles of a surface sorted into cells of its box, so that those in a part of space are found, and
// only those that may be seen are drawn.

const CELLS = 16; // along each axis

// Changes the order of the triangles; each cell has those whose first corner lies in it.
function sortIntoCells(surface) {
  const { points, triangles } = surface, count = triangles.length / 3, shift = 16 - Math.log2(CELLS);
  const cellOf = new Uint16Array(count), ends = new Uint32Array(CELLS ** 3 + 1);
  for (let t = 0; t < count; ++t) {
    const v = 4 * triangles[3 * t];
    cellOf[t] = points[v] >> shift | (points[v + 1] >> shift) * CELLS | (points[v + 2] >> shift) * CELLS ** 2;
    ++ends[cellOf[t] + 1];
  }
  for (let c = 0; c < CELLS ** 3; ++c)
    ends[c + 1] += ends[c];
  const firsts = ends.slice(), sorted = new Uint32Array(triangles.length);
  for (let t = 0; t < count; ++t) {
    const to = 3 * firsts[cellOf[t]]++;
    for (let k = 0; k < 3; ++k)
      sorted[to + k] = triangles[3 * t + k];
  }
  surface.triangles = sorted;
  surface.cells = [];
  for (let c = 0; c < CELLS ** 3; ++c)
    if (ends[c] < ends[c + 1])
      surface.cells.push(boxOf(points, sorted, 3 * ends[c], 3 * ends[c + 1]));
}

function boxOf(points, triangles, first, end) {
  const low = [STEPS, STEPS, STEPS], high = [0, 0, 0];
  for (let i = first; i < end; ++i)
    for (let k = 0; k < 3; ++k) {
      const x = points[4 * triangles[i] + k];
      low[k] = Math.min(low[k], x);
      high[k] = Math.max(high[k], x);
    }
  return { first, end, low, high };
}

// Where the steps of points are in space.
class Placing {
  constructor(size) {
    this.scale = scaled(size, 1 / STEPS);
    this.shift = scaled(size, -1 / 2);
  }

  at(points, v) {
    return [0, 1, 2].map(k => points[4 * v + k] * this.scale[k] + this.shift[k]);
  }

  // The middle of a box, and half its extents.
  box({ low, high }) {
    return { middle: low.map((x, k) => (x + high[k]) / 2 * this.scale[k] + this.shift[k]),
             half: low.map((x, k) => (high[k] - x) / 2 * this.scale[k]) };
  }
}

// First and end of the runs of triangles in the cells that are wanted.
function runsOf(cells, isWanted) {
  const runs = [];
  for (const cell of cells) {
    const last = runs[runs.length - 1];
    if (!isWanted(cell))
      continue;
    if (last && last[1] === cell.first)
      last[1] = cell.end;
    else
      runs.push([cell.first, cell.end]);
  }
  return runs;
}

// How many corners are in runs.
const lengthOf = runs => runs.reduce((all, [first, end]) => all + end - first, 0);

// Whether a box may be seen: it is not beyond one of the sides of the picture.
function sides(columns) {
  const row = r => [0, 1, 2, 3].map(c => columns[4 * c + r]), w = row(3);
  return [0, 1, 2].flatMap(r => [sum(w, row(r)), difference(w, row(r))]);
}

const meetsAll = (planes, { middle, half }) => planes.every(([a, b, c, d]) =>
  a * middle[0] + b * middle[1] + c * middle[2] + d +
  Math.abs(a) * half[0] + Math.abs(b) * half[1] + Math.abs(c) * half[2] >= 0);

const MANY = 3e5; // corners

// Corners of the triangles in the cells that meet a ball, as places in space: nine numbers of each. Of fewer
// and larger ones, if they were many.
function trianglesNear(surface, placing, place, radius) {
  const { points, cells } = surface, { scale, shift } = placing;
  const isWanted = cell => {
    const { middle, half } = placing.box(cell);
    return Math.hypot(...place.map((x, k) => Math.max(0, Math.abs(x - middle[k]) - half[k]))) < radius;
  };
  let triangles = surface.triangles, runs = runsOf(cells, isWanted), length = 0;
  if (lengthOf(runs) > MANY)
    [triangles, runs] = [surface.coarse, [[0, surface.coarse.length]]];
  const corners = new Float32Array(3 * lengthOf(runs));
  for (const [first, end] of runs)
    for (let i = first; i < end; i += 3) {
      let isIn = true;
      for (let k = 0; k < 3; ++k) {
        const x = points[4 * triangles[i] + k] * scale[k] + shift[k];
        const y = points[4 * triangles[i + 1] + k] * scale[k] + shift[k];
        const z = points[4 * triangles[i + 2] + k] * scale[k] + shift[k];
        corners[length + 3 * k] = x;
        corners[length + 3 * k + 1] = y;
        corners[length + 3 * k + 2] = z;
        isIn = isIn && Math.min(x, y, z) < place[k] + radius && Math.max(x, y, z) > place[k] - radius;
      }
      length += isIn ? 9 : 0;
    }
  return corners.subarray(0, length); // x of the three corners, then y, then z
}

// The nearest point of a surface on a ray, or null; what `isHidden` is passed through.
function firstOn(surface, placing, eye, direction, isHidden) {
  let nearest = Infinity;
  const { points, triangles } = surface, meetsRay = cell => {
    const { middle, half } = placing.box(cell);
    let [low, high] = [0, Infinity];
    for (let k = 0; k < 3; ++k) {
      const a = (middle[k] - half[k] - eye[k]) / direction[k], b = (middle[k] + half[k] - eye[k]) / direction[k];
      low = Math.max(low, Math.min(a, b) - 1e-6);
      high = Math.min(high, Math.max(a, b) + 1e-6);
    }
    return !(low > high);
  };
  for (const [first, end] of runsOf(surface.cells, meetsRay))
    for (let i = first; i < end; i += 3) {
      const p = placing.at(points, triangles[i]);
      const [u, v] = [1, 2].map(k => difference(placing.at(points, triangles[i + k]), p));
      const normal = cross(direction, v), factor = dot(u, normal);
      if (factor === 0)
        continue;
      const to = difference(eye, p), other = cross(to, u);
      const s = dot(to, normal) / factor, t = dot(direction, other) / factor, along = dot(v, other) / factor;
      if (s >= 0 && t >= 0 && s + t <= 1 && along > 0 && along < nearest &&
          !isHidden(sum(eye, scaled(direction, along))))
        nearest = along;
    }
  return nearest < Infinity ? sum(eye, scaled(direction, nearest)) : null;
}
