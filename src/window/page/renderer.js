// Draws surfaces and lines with WebGL, as a view says. The faces are never touched here once they are on the
// graphics card.

// Where a colour is partly there.
function divideByOpacity(pixels) {
  for (let i = 3; i < pixels.length; i += 4)
    if (pixels[i] % 255 > 0)
      for (let k = 1; k <= 3; ++k)
        pixels[i - k] *= 255 / pixels[i];
}

// How much is drawn: while it moves less, in half the size, which takes far less time where there is no graphics
// card; at rest first what looks to the eye, then all, with smooth rims.
const DETAIL = {
  moving: { isCoarse: true, part: 0.5, samples: 0 },
  plain: { part: 1, samples: 0, isCulled: true },
  smooth: { part: 1, samples: 4 },
};

const SLICE = 1.5e5; // corners of triangles that are drawn without a break

// All of what is done in steps.
function finish(steps) {
  while (!steps.next().done);
}

class Renderer {
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext('webgl2', { antialias: false, depth: false });
    if (!this.gl)
      throw new Error('this browser does not support WebGL 2, or it is disabled');
    this.surfaces = [];
    this.programs = { surface: this.program(SURFACE_VERTEX, SURFACE_FRAGMENT),
                      line: this.program(LINE_VERTEX, LINE_FRAGMENT) };
  }

  program(vertex, fragment) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new Error(gl.getProgramInfoLog(program));
    const uniforms = {};
    for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; --i) {
      const { name } = gl.getActiveUniform(program, i);
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms, at: name => gl.getAttribLocation(program, name) };
  }

  // ---- what is drawn

  buffer(data, target = this.gl.ARRAY_BUFFER) {
    const buffer = this.gl.createBuffer();
    this.gl.bindBuffer(target, buffer);
    this.gl.bufferData(target, data, this.gl.STATIC_DRAW);
    return buffer;
  }

  attribute(index, count, type, stride) {
    const gl = this.gl;
    gl.enableVertexAttribArray(index);
    if (type === gl.UNSIGNED_INT)
      gl.vertexAttribIPointer(index, count, type, stride, 0);
    else
      gl.vertexAttribPointer(index, count, type, type === gl.BYTE, stride, 0);
  }

  addSurface({ points, normals, partOf, triangles, coarse, cells, hasInside }) {
    const gl = this.gl, { at } = this.programs.surface, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    this.buffer(points);
    this.attribute(at('point'), 3, gl.UNSIGNED_SHORT, 8);
    const normalBuffer = this.buffer(normals);
    this.attribute(at('normal'), 4, gl.BYTE, 4);
    if (partOf) {
      this.buffer(partOf);
      this.attribute(at('part'), 1, gl.UNSIGNED_INT, 4);
    } else {
      gl.vertexAttribI4ui(at('part'), 0, 0, 0, 0);
    }
    const full = this.indices(triangles);
    this.surfaces.push({ array, full, coarse: coarse === triangles ? full : this.indices(coarse), cells, triangles,
                         normalBuffer, hasInside, palette: this.palette() });
    gl.bindVertexArray(null);
  }

  indices(triangles) {
    return { buffer: this.buffer(triangles, this.gl.ELEMENT_ARRAY_BUFFER), count: triangles.length };
  }

  setNormals(number, normals) {
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.surfaces[number].normalBuffer);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, normals, this.gl.STATIC_DRAW);
  }

  // Sides of triangles, those that two have once.
  edges(surface) {
    const { triangles } = surface, edges = new Uint32Array(2 * triangles.length);
    let end = 0;
    for (let i = 0; i < triangles.length; ++i) {
      const a = triangles[i], b = triangles[i % 3 === 2 ? i - 2 : i + 1];
      if (a < b) {
        edges[end++] = a;
        edges[end++] = b;
      }
    }
    this.gl.bindVertexArray(null);
    return this.indices(edges.subarray(0, end));
  }

  palette() {
    const gl = this.gl, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
  }

  // Colours with a fourth number.
  fill(texture, colours) {
    const gl = this.gl, rows = Math.max(1, Math.ceil(colours.length / PALETTE_WIDTH));
    const data = new Uint8Array(4 * PALETTE_WIDTH * rows);
    colours.forEach((colour, i) => data.set(colour, 4 * i));
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, PALETTE_WIDTH, rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, data);
  }

  setLines(points) {
    this.lines ||= new Lines(this);
    this.lines.setPoints(points);
  }

  // ---- a picture

  // How many triangles are in what may be seen.
  prepare(view) {
    const surface = this.surfaces[view.shown], { columns } = view.camera.matrix();
    const [a, b, c, d] = this.cutPlane = view.cutPlane(), planes = [...sides(columns), [-a, -b, -c, d]];
    this.runs = runsOf(surface.cells, cell => meetsAll(planes, view.placing.box(cell)));
    return lengthOf(this.runs) / 3;
  }

  // Onto the canvas, as large as that is, in steps between which others may have the processor.
  *show(view, background, detail, pixelRatio) {
    const { width, height } = this.canvas, { part, samples } = detail;
    const size = [width, height].map(x => Math.max(1, Math.round(x * part))), key = [...size, samples].join();
    const known = (this.screens ||= new Map()).get(detail);
    if (known?.key !== key) {
      known?.free();
      this.screens.set(detail, { ...this.target(...size, samples), key });
    }
    const { framebuffer } = this.screens.get(detail), [drawnWidth, drawnHeight] = size;
    yield* this.paint(view, { framebuffer, width: drawnWidth, height: drawnHeight, background, detail,
                              pixelRatio: pixelRatio * part });
    this.copy(framebuffer, size, null, [width, height]);
  }

  copy(from, size, to, other) {
    const gl = this.gl;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to);
    gl.blitFramebuffer(0, 0, ...size, 0, 0, ...other, gl.COLOR_BUFFER_BIT,
                       size[0] === other[0] ? gl.NEAREST : gl.LINEAR);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  begin(view, width, height, detail, pixelRatio) {
    Object.assign(this, { view, detail });
    this.prepare(view);
    this.lines.begin(view, [width, height], detail, pixelRatio);
    this.isCulled = detail.isCulled && this.surfaces[view.shown].hasInside && view.cut.part >= 1 &&
                    !view.camera.isCutOpen;
  }

  *paint(view, { framebuffer, width, height, background, detail = DETAIL.smooth, pixelRatio }) {
    const gl = this.gl;
    this.begin(view, width, height, detail, pixelRatio);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.viewport(0, 0, width, height);
    gl.clearColor(...background);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const isOverBones = view.hasBones && view.opacity < 1;
    if (isOverBones)
      this.drawBones();
    yield* this.drawSurfaces();
    if (view.isWired && !detail.isCoarse)
      this.drawEdges();
    yield* this.drawLines(isOverBones);
  }

  use(program) {
    const gl = this.gl, { uniforms } = program, { camera, placing } = this.view;
    const { columns, eye, near } = camera.matrix();
    gl.useProgram(program.program);
    gl.uniformMatrix4fv(uniforms.matrix, false, columns);
    gl.uniform3fv(uniforms.scale, placing.scale);
    gl.uniform3fv(uniforms.shift, placing.shift);
    gl.uniform3fv(uniforms.eye, eye);
    if (uniforms.near)
      gl.uniform1f(uniforms.near, near);
    return uniforms;
  }

  // A transparent surface: what looks away first, then the nearest that looks to the eye over it.
  *drawSurfaces() {
    const gl = this.gl, { opacity } = this.view, culled = this.isCulled ? gl.BACK : null;
    if (opacity >= 1)
      return yield* this.drawSurface(1, culled);
    yield* this.drawSurface(opacity, gl.FRONT, true);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.colorMask(false, false, false, false);
    yield* this.drawSurface(1, culled);
    gl.colorMask(true, true, true, true);
    yield* this.drawSurface(opacity, culled, true);
  }

  useSurface(opacity, ink) {
    const gl = this.gl, surface = this.surfaces[this.view.shown], { right, up, back } = this.view.camera;
    const uniforms = this.use(this.programs.surface);
    gl.uniform4fv(uniforms.cut, this.cutPlane);
    gl.uniform4fv(uniforms.ink, ink);
    gl.uniform1i(uniforms.has_inside, surface.hasInside ? 1 : 0);
    for (const [name, axis] of Object.entries({ right, up, back }))
      gl.uniform3fv(uniforms[name], axis);
    gl.uniform1f(uniforms.opacity, opacity);
    const isDimmed = opacity < 1 && Math.max(...this.view.background) < 0.5; // by what shows through
    gl.uniform1f(uniforms.gain, isDimmed ? 1.5 : 1);
    gl.bindTexture(gl.TEXTURE_2D, surface.palette);
    gl.bindVertexArray(surface.array);
    return surface;
  }

  *drawSurface(opacity, culled = null, isBlended = false) {
    const gl = this.gl, surface = this.useSurface(opacity, [0, 0, 0, 0]), { isCoarse } = this.detail;
    (isBlended ? gl.enable : gl.disable).call(gl, gl.BLEND);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    (culled ? gl.enable : gl.disable).call(gl, gl.CULL_FACE);
    if (culled)
      gl.cullFace(culled);
    const { buffer, count } = isCoarse ? surface.coarse : surface.full;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    let due = 0;
    for (const [first, end] of isCoarse && surface.coarse !== surface.full ? [[0, count]] : this.runs)
      for (let i = first; i < end; i += SLICE) {
        const length = Math.min(SLICE, end - i);
        gl.drawElements(gl.TRIANGLES, length, gl.UNSIGNED_INT, 4 * i);
        if ((due += length) >= SLICE) {
          due = 0;
          yield;
        }
      }
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.disable(gl.CULL_FACE);
  }

  drawEdges() {
    const gl = this.gl, surface = this.useSurface(1, [0.1, 0.12, 0.16, 0.35]);
    if (!surface.edges) {
      surface.edges = this.edges(surface);
      gl.bindVertexArray(surface.array);
    }
    gl.enable(gl.BLEND);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, surface.edges.buffer);
    gl.drawElements(gl.LINES, surface.edges.count, gl.UNSIGNED_INT, 0);
  }

  // What lies inside, solid: before the surface is laid over it, and where it looks out after that.
  drawBones() {
    const gl = this.gl;
    gl.disable(gl.BLEND);
    gl.depthMask(true);
    this.lines.isRound = true;
    this.lines.draw(gl.LEQUAL, 0, 1);
    this.lines.isRound = false;
  }

  // Hidden ones pale, and the paler the more there are; the stencil keeps each pixel to one of them. Of those
  // that are seen the nearest is on top: their cores cover depth, but not their faint rims, which would hide
  // the next segments.
  *drawLines(isOverBones) {
    const gl = this.gl, { isAnyLit, opacity, numberShown } = this.view;
    const crowd = Math.min(1, Math.sqrt(30 / Math.max(1, numberShown)));
    gl.enable(gl.BLEND);
    gl.depthMask(false);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    gl.stencilFunc(gl.EQUAL, 0, 255);
    if (isAnyLit)
      this.lines.draw(gl.GREATER, 1, 0.65);
    if (!isOverBones)
      this.lines.draw(gl.GREATER, 0, (0.34 + 0.5 * (1 - opacity)) * crowd);
    yield;
    gl.disable(gl.STENCIL_TEST);
    if (isOverBones)
      this.drawBones();
    else
      yield* this.drawOverEachOther(0);
    if (isAnyLit)
      yield* this.drawOverEachOther(1);
    gl.depthMask(true);
  }

  *drawOverEachOther(wanted) {
    const gl = this.gl;
    if (!this.detail.isCoarse) {
      gl.depthMask(true);
      gl.colorMask(false, false, false, false);
      this.lines.draw(gl.LEQUAL, wanted, 1, true);
      gl.colorMask(true, true, true, true);
      gl.depthMask(false);
      yield;
    }
    this.lines.draw(gl.LEQUAL, wanted, 1);
  }

  // ---- other pictures

  // Something to draw into that is not seen.
  target(width, height, samples) {
    const gl = this.gl, framebuffer = gl.createFramebuffer(), buffers = [];
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    samples = Math.min(samples, gl.getParameter(gl.MAX_SAMPLES));
    for (const [format, place] of [[gl.RGBA8, gl.COLOR_ATTACHMENT0],
                                   [gl.DEPTH24_STENCIL8, gl.DEPTH_STENCIL_ATTACHMENT]]) {
      buffers.push(gl.createRenderbuffer());
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffers[buffers.length - 1]);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffers[buffers.length - 1]);
    }
    const free = () => {
      buffers.forEach(buffer => gl.deleteRenderbuffer(buffer));
      gl.deleteFramebuffer(framebuffer);
    };
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) {
      free();
      throw new Error('the graphics card does not have enough memory');
    }
    return { framebuffer, free };
  }

  pixels(framebuffer, width, height) {
    const gl = this.gl, pixels = new Uint8Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return pixels;
  }

  // For each pixel, from below, the number of a line, plus one, in three bytes; the fourth is 255 if it is
  // seen there, and less if it is behind the surface.
  numbers(view, width, height, isCoarse) {
    const gl = this.gl, { framebuffer, free } = this.target(width, height, 0);
    this.begin(view, width, height, isCoarse ? DETAIL.moving : DETAIL.smooth, width / this.canvas.clientWidth);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.depthMask(true);
    this.lines.draw(gl.LEQUAL, 2, 0.5);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.colorMask(false, false, false, false);
    finish(this.drawSurface(1));
    gl.colorMask(true, true, true, true);
    this.lines.draw(gl.LEQUAL, 2, 1);
    const pixels = this.pixels(framebuffer, width, height);
    free();
    return pixels;
  }

  // A picture of any size, from above, as colours that are not multiplied by their opacities.
  image(view, width, height, background) {
    const drawn = this.target(width, height, width * height > 8e6 ? 0 : 4), plain = this.target(width, height, 0);
    const pixelRatio = height / this.canvas.clientHeight;
    finish(this.paint(view, { framebuffer: drawn.framebuffer, width, height, background, pixelRatio }));
    this.copy(drawn.framebuffer, [width, height], plain.framebuffer, [width, height]);
    const rows = this.pixels(plain.framebuffer, width, height), pixels = new Uint8ClampedArray(rows.length);
    for (let y = 0; y < height; ++y)
      pixels.set(rows.subarray(4 * width * y, 4 * width * (y + 1)), 4 * width * (height - 1 - y));
    if (background[3] < 1)
      divideByOpacity(pixels);
    [drawn, plain].forEach(({ free }) => free());
    if (this.gl.isContextLost())
      throw new Error('the graphics card does not have enough memory');
    return new ImageData(pixels, width, height);
  }

  get largestSide() {
    return this.gl.getParameter(this.gl.MAX_RENDERBUFFER_SIZE);
  }

  // Until all that was asked for is drawn.
  wait() {
    this.pixels(null, 1, 1);
  }

  // The same, but does not hold up the page.
  async drawn() {
    const gl = this.gl, fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    do
      await soon();
    while (!gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED);
    gl.deleteSync(fence);
  }
}
