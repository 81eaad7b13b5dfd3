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

// Fewer points of lines, so that none that is left out is further than `tolerance` steps from where the line then
// is. Where a line has radii all stay.
function thinned(points, tolerance) {
  const kept = [], goesOn = i => points[4 * i + 3] % 2 === 1, count = points.length / 4;
  for (let first = 0; first < count; ++first) {
    kept.push(first);
    while (goesOn(first)) {
      let next = first + 1;
      while (goesOn(next) && !(points[4 * next] >>> 16) && isStraight(points, first, next + 1, tolerance))
        ++next;
      kept.push(first = next);
    }
  }
  return Uint32Array.from({ length: 4 * kept.length }, (_, i) => points[4 * kept[i >> 2] + i % 4]);
}

const LONGEST = 100; // segments that become one

function isStraight(points, first, last, tolerance) {
  const from = [0, 1, 2].map(k => stepsOf(points, first, k)),
        along = from.map((x, k) => stepsOf(points, last, k) - x), length2 = dot(along, along);
  for (let i = first + 1; i < last; ++i) {
    const [x, y, z] = from.map((x, k) => stepsOf(points, i, k) - x);
    const t = clamped((x * along[0] + y * along[1] + z * along[2]) / length2 || 0, 0, 1);
    if ((x - t * along[0]) ** 2 + (y - t * along[1]) ** 2 + (z - t * along[2]) ** 2 > tolerance ** 2)
      return false;
  }
  return last - first <= LONGEST;
}
