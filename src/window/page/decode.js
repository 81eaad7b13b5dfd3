// What a page carries: numbers of variable length, in streams one after the other, deflated, in
// base 64. See encoding.h for what they mean.

const STEPS = 65535; // of a coordinate, from one side of the box to the other

async function inflated(id) {
  const text = atob(document.getElementById(id).textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Reads numbers: seven bits in each byte, the least first; the eighth says that more follow.
class Numbers {
  constructor(bytes, at) {
    this.bytes = bytes;
    this.at = at;
  }

  next() {
    let byte = this.bytes[this.at++], value = byte & 127;
    for (let shift = 7; byte > 127; shift += 7) {
      byte = this.bytes[this.at++];
      value |= (byte & 127) << shift;
    }
    return value;
  }

  nextSigned() {
    const value = this.next();
    return (value >>> 1) ^ -(value & 1);
  }
}

// One reader for each stream.
function streams(bytes, lengths) {
  let at = 0;
  return lengths.map(length => {
    const numbers = new Numbers(bytes, at);
    at += length;
    return numbers;
  });
}

// The faces around each vertex in turn, as far as they were not there yet; a vertex that is met for
// the first time gets the next number.
function decodeSurface(bytes, surface) {
  const [counts, corners, x, y, z, partSteps] = streams(bytes, surface.streams);
  const points = new Uint16Array(4 * surface.vertices), triangles = new Uint32Array(3 * surface.faces);
  const parts = new Uint32Array(surface.parts ? surface.faces : 0);
  let known = 0, face = 0, part = 0;
  const meet = near => {
    for (const [i, numbers] of [x, y, z].entries())
      points[4 * known + i] = points[4 * near + i] + numbers.nextSigned();
    return known++;
  };
  const corner = near => {
    const code = corners.next();
    return code === 0 ? meet(near) : known - code;
  };
  for (let v = 0; v < surface.vertices; ++v) {
    if (v === known)
      meet(v === 0 ? 0 : v - 1);
    for (let n = counts.next(); n > 0; --n, ++face) {
      const a = corner(v), b = corner(a);
      triangles.set([v, a, b], 3 * face);
      if (surface.parts)
        parts[face] = part += partSteps.nextSigned();
    }
  }
  return { points, triangles, parts };
}

// A vertex has copies, each for those faces around it that are like the first of them. `original`
// leads back from copies, which are chained by `next`.
function splitVertices(points, triangles, areLike) {
  const count = points.length / 4;
  const first = new Array(count).fill(-1), next = new Array(count).fill(-1), original = [];
  triangles.forEach((v, corner) => {
    const face = Math.floor(corner / 3), fits = w => first[w] === -1 || areLike(face, first[w], v);
    let w = v;
    while (!fits(w) && next[w] !== -1)
      w = next[w];
    if (!fits(w)) {
      w = next[w] = count + original.length;
      next.push(-1);
      first.push(-1);
      original.push(v);
    }
    if (first[w] === -1)
      first[w] = face;
    triangles[corner] = w;
  });
  return { first, original };
}

// Four numbers of each vertex, with those of copies.
function withCopies(numbers, original) {
  const all = new numbers.constructor(numbers.length + 4 * original.length);
  all.set(numbers);
  original.forEach((v, i) => all.set(numbers.subarray(4 * v, 4 * v + 4), numbers.length + 4 * i));
  return all;
}

// A vertex belongs to one part: where parts meet it has copies.
function splitByParts({ points, triangles, normals, parts }) {
  const { first, original } = splitVertices(points, triangles, (f, g) => parts[f] === parts[g]);
  return { points: withCopies(points, original), normals: withCopies(normals, original), triangles,
           partOf: Uint32Array.from(first, face => parts[face] || 0) };
}

// Whether each side of a triangle is passed the other way by another one: the numbers of both cancel.
function isClosed(triangles) {
  let sum = 0;
  for (let i = 0; i < triangles.length; ++i) {
    const a = triangles[i], b = triangles[i % 3 === 2 ? i - 2 : i + 1];
    const mixed = Math.imul(Math.min(a, b) ^ 0x9e3779b9, 0x85ebca6b) ^
                  Math.imul(Math.max(a, b) + 0x27d4eb2f, 0xc2b2ae35);
    sum = sum + (a < b ? mixed : -mixed) | 0;
  }
  return sum === 0;
}

// A closed surface that looks inwards is turned over: what is looked at is its outside.
function turnOutwards({ points, triangles }) {
  let volume = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const a = 4 * triangles[i], b = 4 * triangles[i + 1], c = 4 * triangles[i + 2];
    const at = (v, k) => points[v + k] / STEPS - 0.5;
    volume += at(a, 0) * (at(b, 1) * at(c, 2) - at(b, 2) * at(c, 1)) +
              at(a, 1) * (at(b, 2) * at(c, 0) - at(b, 0) * at(c, 2)) +
              at(a, 2) * (at(b, 0) * at(c, 1) - at(b, 1) * at(c, 0));
  }
  if (volume < 0)
    for (let i = 0; i < triangles.length; i += 3)
      [triangles[i], triangles[i + 1]] = [triangles[i + 1], triangles[i]];
}

const CREASE = 0.87; // cosine of an angle between normals beyond which a surface is not smooth

// Three numbers of each face: a normal as long as the face is large.
function faceNormals(points, triangles, size) {
  const normals = new Float32Array(triangles.length);
  const [sx, sy, sz] = size.map(s => s / STEPS);
  for (let i = 0; i < triangles.length; i += 3) {
    const a = 4 * triangles[i], b = 4 * triangles[i + 1], c = 4 * triangles[i + 2];
    const ux = (points[b] - points[a]) * sx, vx = (points[c] - points[a]) * sx;
    const uy = (points[b + 1] - points[a + 1]) * sy, vy = (points[c + 1] - points[a + 1]) * sy;
    const uz = (points[b + 2] - points[a + 2]) * sz, vz = (points[c + 2] - points[a + 2]) * sz;
    normals[i] = uy * vz - uz * vy;
    normals[i + 1] = uz * vx - ux * vz;
    normals[i + 2] = ux * vy - uy * vx;
  }
  return normals;
}

// Three numbers of each vertex: the sum over the faces around it.
function sumsAround(count, triangles, ofFaces) {
  const sums = new Float32Array(3 * count);
  triangles.forEach((v, corner) => {
    const face = corner - corner % 3;
    for (let k = 0; k < 3; ++k)
      sums[3 * v + k] += ofFaces[face + k];
  });
  return sums;
}

// Whether the i-th of some vectors and the j-th of others are about parallel.
function areParallel(u, i, v, j) {
  i *= 3;
  j *= 3;
  const product = u[i] * v[j] + u[i + 1] * v[j + 1] + u[i + 2] * v[j + 2];
  const squares = (u[i] ** 2 + u[i + 1] ** 2 + u[i + 2] ** 2) * (v[j] ** 2 + v[j + 1] ** 2 + v[j + 2] ** 2);
  return squares === 0 || product > 0 && product ** 2 > CREASE ** 2 * squares;
}

// Adds normals of vertices, of length 127, and how open the sky is. Those at creases have copies, so that what
// is flat up to a crease looks flat.
function withNormals({ points, triangles, parts }, size) {
  const ofFaces = faceNormals(points, triangles, size);
  let sums = sumsAround(points.length / 4, triangles, ofFaces);
  const isSmooth = new Uint8Array(points.length / 4).fill(1);
  triangles.forEach((v, corner) => {
    if (isSmooth[v] && !areParallel(sums, v, ofFaces, Math.floor(corner / 3)))
      isSmooth[v] = 0;
  });
  const { original } = splitVertices(points, triangles,
                                     (f, g, v) => isSmooth[v] || areParallel(ofFaces, f, ofFaces, g));
  const all = withCopies(points, original), normals = new Int8Array(all.length);
  sums = sumsAround(all.length / 4, triangles, ofFaces);
  for (let v = 0; v < sums.length / 3; ++v) {
    const length = Math.hypot(sums[3 * v], sums[3 * v + 1], sums[3 * v + 2]) || 1;
    for (let i = 0; i < 3; ++i)
      normals[4 * v + i] = Math.round(127 * sums[3 * v + i] / length);
    normals[4 * v + 3] = 127; // as open as can be
  }
  return { points: all, triangles, normals, parts };
}

async function loadSurface(surface, id, size) {
  const coded = decodeSurface(await inflated(id), surface), hasInside = isClosed(coded.triangles);
  if (hasInside)
    turnOutwards(coded);
  const creased = withNormals(coded, size);
  const loaded = surface.parts ? splitByParts(creased) : creased;
  sortIntoCells(loaded);
  loaded.coarse = coarseTriangles(loaded);
  return { ...surface, ...loaded, hasInside };
}

// All lines in one array of points; the fourth number of a point is twice that of its line, and one
// more if the line goes on. Above the 16 bits of the first two there are the radius, in steps of the
// largest extent, and the width, in 16ths.
async function loadLines(scene) {
  const total = scene.lines.reduce((sum, line) => sum + line.points + (line.closed ? 1 : 0), 0);
  const points = new Uint32Array(4 * total);
  const numbers = streams(await inflated('lines'), scene.lineStreams);
  const last = [0, 0, 0];
  let at = 0, radius = 0;
  scene.lines.forEach((line, index) => {
    const width = 16 * scene.groups[line.group].width;
    line.first = at;
    for (let i = 0; i < line.points; ++i, ++at) {
      for (let k = 0; k < 3; ++k)
        points[4 * at + k] = last[k] += numbers[k].nextSigned();
      if (line.radii)
        points[4 * at] |= (radius += numbers[3].nextSigned()) << 16;
      points[4 * at + 1] |= width << 16;
    }
    if (line.closed)
      points.copyWithin(4 * at++, 4 * line.first, 4 * line.first + 3);
    line.last = at - 1;
    for (let i = line.first; i < at; ++i)
      points[4 * i + 3] = 2 * index + (i < line.last ? 1 : 0);
  });
  return points;
}

// Where a closed line is after a part of its length, in steps from its first point.
function placeOn(points, line, part, scale) {
  const at = i => [0, 1, 2].map(k => stepsOf(points, i, k)), begin = at(line.first), ends = [0];
  for (let i = line.first; i < line.last; ++i) {
    const [p, q] = [at(i), at(i + 1)];
    ends.push(ends[ends.length - 1] + Math.hypot(...p.map((x, k) => (q[k] - x) * scale[k])));
  }
  const wanted = part * ends[ends.length - 1];
  const next = Math.max(1, ends.findIndex(end => end >= wanted)), span = ends[next] - ends[next - 1];
  const t = span > 0 ? (wanted - ends[next - 1]) / span : 0;
  const [p, q] = [at(line.first + next - 1), at(Math.min(line.last, line.first + next))];
  return p.map((x, k) => x + t * (q[k] - x) - begin[k]);
}

// The k-th coordinate of a point of the lines, in steps.
const stepsOf = (points, i, k) => points[4 * i + k] & STEPS;
