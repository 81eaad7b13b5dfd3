// Less of a surface and of lines, for while they move where drawing takes long: the same points, fewer
// triangles and segments.

const ENOUGH = 1e5; // triangles

// As many as are enough: points of finer or of coarser cells become one.
function coarseTriangles(surface) {
  let coarse = surface.triangles;
  for (let bits = 7; coarse.length > 3 * ENOUGH && bits > 4; --bits)
    coarse = clustered(surface, bits);
  return coarse;
}

// Each point goes to the first one in its cell; what becomes a line or a point is left out. `bits` are those
// of the number of a cell along each axis.
function clustered({ points, triangles, partOf }, bits) {
  const first = new Int32Array(1 << 3 * bits).fill(-1), count = points.length / 4;
  const shift = 16 - bits, home = new Uint32Array(count);
  for (let v = 0; v < count; ++v) {
    const cell = points[4 * v] >> shift | points[4 * v + 1] >> shift << bits | points[4 * v + 2] >> shift << 2 * bits;
    if (first[cell] === -1)
      first[cell] = v;
    home[v] = partOf && partOf[first[cell]] !== partOf[v] ? v : first[cell];
  }
  const kept = new Uint32Array(triangles.length);
  let end = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const a = home[triangles[i]], b = home[triangles[i + 1]], c = home[triangles[i + 2]];
    if (a !== b && b !== c && c !== a) {
      kept[end++] = a;
      kept[end++] = b;
      kept[end++] = c;
    }
  }
  return kept.slice(0, end);
}

// Points of a line that are not near each other, and its ends.
function coarseLines(points) {
  const kept = [], near = STEPS / 100;
  for (let i = 0, last = 0; i < points.length; i += 4) {
    const isFirst = i === 0 || points[i + 3] >> 1 !== points[i - 1] >> 1;
    const isFar = () => [0, 1, 2].some(k => Math.abs(stepsOf(points, i / 4, k) - stepsOf(points, last / 4, k)) > near);
    if (isFirst || points[i + 3] % 2 === 0 || isFar()) {
      kept.push(...points.subarray(i, i + 4));
      last = i;
    }
  }
  return Uint32Array.from(kept);
}
