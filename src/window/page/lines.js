// Lines on the graphics card: the points of all of them in one texture, their colours in another. Where the
// difference is not seen, fewer points stand for them; and only those are drawn that may be seen.

const TOLERANCES = [200, 25, 0]; // steps by which lines may be elsewhere: while they move, from far away, and else

class Lines {
  constructor(renderer) {
    const { gl } = renderer;
    Object.assign(this, { renderer, gl, palette: renderer.palette(), nothing: gl.createVertexArray(), states: [],
                          details: [], isRound: false });
  }

  setPoints(points) {
    this.details.forEach(({ texture }) => this.gl.deleteTexture(texture));
    this.details = TOLERANCES.map(tolerance => {
      const kept = tolerance > 0 ? thinned(points, tolerance) : points;
      return { tolerance, texture: this.texture(kept), lines: boxesOfLines(kept) };
    });
  }

  texture(points) {
    const { gl } = this, texture = this.renderer.palette(), count = points.length / 4;
    const rows = Math.max(1, Math.ceil(count / PALETTE_WIDTH));
    const data = new Uint32Array(4 * PALETTE_WIDTH * rows);
    data.set(points);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32UI, PALETTE_WIDTH, rows, 0, gl.RGBA_INTEGER,
                  gl.UNSIGNED_INT, data);
    return texture;
  }

  // With the states of lines: hidden 0, shown 128, lit 255.
  fill(colours) {
    this.states = colours.map(colour => colour[3]);
    this.renderer.fill(this.palette, colours);
  }

  // Finds what may be seen in a picture of that size.
  begin(view, size, detail, pixelRatio) {
    const { camera, placing, lineWidth } = view, planes = sides(camera.matrix().columns);
    const step = Math.max(...placing.scale); // of radii
    const pixel = 2 * camera.distance * camera.extent[1] / size[1]; // where one looks at
    const rim = 4 * lineWidth * pixelRatio * pixel;
    Object.assign(this, { view, size, pixelRatio, pixel, step });
    this.chosen = this.details.find(({ tolerance }) => detail.isCoarse || tolerance * step <= pixel / 2);
    this.runs = [state => state > 0, state => state === 255].map(isWanted => runsOf(this.chosen.lines, line => {
      const { middle, half } = placing.box(line);
      return isWanted(this.states[line.index]) &&
             meetsAll(planes, { middle, half: half.map(x => x + line.radius * step + rim) });
    }));
  }

  // `wanted`: 0 for all that is shown, 1 for what is lit, 2 for numbers in place of colours; `isCore`: without rims.
  draw(depth, wanted, strength, isCore = false) {
    const { gl, renderer, view: { camera, lineWidth, isThick }, isRound } = this;
    const uniforms = renderer.use(renderer.programs.line), { depth: factor, offset } = camera.matrix();
    const pixels = camera.distance / this.pixel; // of a unit of length, at the depth 1
    gl.uniform2fv(uniforms.size, this.size);
    gl.uniform1f(uniforms.width, lineWidth * this.pixelRatio);
    gl.uniform1f(uniforms.strength, strength);
    gl.uniform1i(uniforms.wanted, wanted);
    gl.uniform1f(uniforms.least, isCore ? 0.98 : wanted === 2 || strength < 1 || isRound ? 0.5 : 0.02);
    gl.uniform1f(uniforms.thick, isThick && isRound ? this.step * pixels : 0);
    gl.uniform3f(uniforms.round, factor, offset, isRound ? pixels : 0);
    gl.uniform1i(uniforms.points, 1);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.chosen.texture);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.palette);
    gl.bindVertexArray(this.nothing);
    gl.depthFunc(depth);
    for (const [first, end] of this.runs[wanted === 1 ? 1 : 0])
      gl.drawArrays(gl.TRIANGLES, 6 * first, 6 * (end - first));
  }
}

// Where the points of each line are in the array, and in the box.
function boxesOfLines(points) {
  const lines = [], count = points.length / 4;
  for (let first = 0, end; first < count; first = end) {
    const low = [STEPS, STEPS, STEPS], high = [0, 0, 0];
    let radius = 0;
    for (end = first; end === first || end < count && points[4 * end - 1] % 2 === 1; ++end) {
      radius = Math.max(radius, points[4 * end] >>> 16);
      for (let k = 0; k < 3; ++k) {
        low[k] = Math.min(low[k], stepsOf(points, end, k));
        high[k] = Math.max(high[k], stepsOf(points, end, k));
      }
    }
    lines.push({ first, end, low, high, radius, index: points[4 * first + 3] >> 1 });
  }
  return lines;
}
