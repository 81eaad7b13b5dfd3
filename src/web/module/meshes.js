// Meshes as arrays, and as files that keep all digits.

const headerOf = (points, triangles) => new TextEncoder().encode(
  `ply\nformat binary_little_endian 1.0\nelement vertex ${points.length / 3}\n` +
  'property double x\nproperty double y\nproperty double z\n' +
  `element face ${triangles.length / 3}\nproperty list uchar uint vertex_indices\nend_header\n`);

const isNumberOfPoint = value => Number.isInteger(value) && value >= 0 && value < 2 ** 32;

// What the file cannot hold; whether points have those numbers is for the tool to say.
function check(mesh) {
  for (const name of ['points', 'triangles']) {
    const array = mesh?.[name];
    if (typeof array !== 'object' || !array || !(array.length % 3 === 0))
      throw new TypeError(`${name}: an array of numbers is expected, three for each`);
  }
  const { triangles } = mesh;
  for (let i = 0; i < triangles.length; ++i)
    if (!isNumberOfPoint(triangles[i]))
      throw new TypeError(`triangles: ${triangles[i]}, at ${i}, is not the number of a point; they count from 0`);
}

// PLY, binary: three doubles a point, three numbers from 0 a triangle.
export function plyOf(mesh) {
  check(mesh);
  const { points, triangles } = mesh, header = headerOf(points, triangles);
  const bytes = new Uint8Array(header.length + 8 * points.length + 13 * (triangles.length / 3));
  const view = new DataView(bytes.buffer);
  bytes.set(header);
  let at = header.length;
  for (let i = 0; i < points.length; ++i, at += 8)
    view.setFloat64(at, points[i], true);
  for (let i = 0; i < triangles.length; ++at) {
    view.setUint8(at, 3);
    for (const end = i + 3; i < end; ++i, at += 4)
      view.setUint32(at + 1, triangles[i], true);
  }
  return bytes;
}

// The words of each line that has any.
function* linesOf(text) {
  for (let begin = 0; begin < text.length;) {
    const end = text.indexOf('\n', begin), line = text.slice(begin, end < 0 ? text.length : end).trim();
    if (line !== '')
      yield line.split(' ');
    begin = end < 0 ? text.length : end + 1;
  }
}

// The arrays of a mesh that the tool wrote in the OFF format, as text with all digits.
export function meshOfOff(bytes) {
  const lines = linesOf(new TextDecoder().decode(bytes));
  lines.next(); // the word OFF
  const [vertices, faces] = lines.next().value.map(Number);
  const points = new Float64Array(3 * vertices), triangles = new Uint32Array(3 * faces);
  const fill = (array, skipped) => {
    for (let i = 0; i < array.length; i += 3) {
      const words = lines.next().value;
      for (let k = 0; k < 3; ++k)
        array[i + k] = Number(words[k + skipped]);
    }
  };
  fill(points, 0);
  fill(triangles, 1);
  return { points, triangles };
}
