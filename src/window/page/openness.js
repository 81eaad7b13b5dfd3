// How much of the sky each vertex sees: cavities are darker. It becomes the fourth number of the normals.

const SKY_CELLS = 96; // of the small pictures from all sides, along each side
const SKY_DIRECTIONS = 40;
const SKY_SAMPLES = 40000; // points that stand for the surface, if it has few vertices

// Points of triangles that are larger than what a vertex stands for, in steps.
function samplesOf({ points, triangles }, size) {
  const count = points.length / 4, wanted = SKY_SAMPLES - count, samples = [];
  if (wanted <= 0)
    return new Float32Array(0);
  const normals = faceNormals(points, triangles, size);
  let whole = 0, due = 0;
  for (let i = 0; i < normals.length; i += 3)
    whole += Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
  for (let i = 0; i < normals.length && whole > 0; i += 3) {
    due += wanted * Math.hypot(normals[i], normals[i + 1], normals[i + 2]) / whole;
    for (; samples.length / 3 < due; ) { // steps by powers of the plastic number leave no gaps
      let s = 0.7548776662466927 * samples.length % 1, t = 0.5698402909980532 * samples.length % 1;
      if (s + t > 1)
        [s, t] = [1 - s, 1 - t];
      const [a, b, c] = [0, 1, 2].map(k => 4 * triangles[i + k]);
      for (let k = 0; k < 3; ++k)
        samples.push(points[a + k] + s * (points[b + k] - points[a + k]) + t * (points[c + k] - points[a + k]));
    }
  }
  return Float32Array.from(samples);
}

// Draws points, `stride` numbers each, into a small picture; keeps where they are, and how near.
function drawSky(depths, points, stride, factors, cells, nearness) {
  const count = points.length / stride, [right, up, back] = factors;
  for (let i = 0, at = 0; i < count; ++i, at += stride) {
    const x = points[at], y = points[at + 1], z = points[at + 2];
    const u = right[0] * x + right[1] * y + right[2] * z + right[3] | 0;
    const v = up[0] * x + up[1] * y + up[2] * z + up[3] | 0;
    const depth = back[0] * x + back[1] * y + back[2] * z, cell = v * SKY_CELLS + u;
    if (depth > depths[cell])
      depths[cell] = depth;
    if (cells) {
      cells[i] = cell;
      nearness[i] = depth;
    }
  }
}

// Calls `pause` now and then, which may say that the rest is not wanted any more.
async function addOpenness(surface, size, pause) {
  const { points, normals } = surface, count = points.length / 4, samples = samplesOf(surface, size);
  const cells = new Uint16Array(count), nearness = new Float32Array(count), depths = new Float32Array(SKY_CELLS ** 2);
  const seen = new Float32Array(count), all = new Float32Array(count), { scale, shift } = new Placing(size);
  const inCells = SKY_CELLS / 2.02;
  for (const back of directions(SKY_DIRECTIONS)) {
    const right = anyAcross(back), axes = [right, cross(back, right), back];
    const factors = axes.map(
      a => [...a.map((x, k) => x * scale[k] * inCells), dot(a, shift) * inCells + SKY_CELLS / 2]);
    depths.fill(-Infinity);
    drawSky(depths, samples, 3, factors);
    drawSky(depths, points, 4, factors, cells, nearness);
    for (let v = 0, n = 0; v < count; ++v, n += 4) {
      const facing = back[0] * normals[n] + back[1] * normals[n + 1] + back[2] * normals[n + 2];
      if (facing <= 0)
        continue;
      all[v] += facing;
      if (nearness[v] > depths[cells[v]] - 3)
        seen[v] += facing;
    }
    if (await pause())
      return false;
  }
  for (let v = 0; v < count; ++v)
    normals[4 * v + 3] = all[v] > 0 ? Math.round(127 * seen[v] / all[v]) : 127;
  return true;
}
