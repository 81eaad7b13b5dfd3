// Draws a surface and lines. The faces are never touched here once they are on the graphics card.

class Viewer {
  constructor(canvas, scene) {
    this.canvas = canvas;
    this.gl = canvas.getContext('webgl2', { antialias: true, stencil: true, alpha: false });
    if (!this.gl)
      throw new Error('This browser does not offer WebGL 2.');
    this.size = scaled(scene.size, 2 / (Math.hypot(...scene.size) || 1));
    this.scale = scaled(this.size, 1 / STEPS);
    this.shift = scaled(this.size, -1 / 2);
    this.camera = new Camera(scene.view, scene.up);
    this.surfaces = [];
    this.shown = 0;
    this.opacity = scene.opacity;
    this.cut = { axis: 0, part: 1, flipped: false };
    this.lineWidth = 4;
    this.isThick = false; // lines that have radii
    this.hasBones = scene.bones;
    this.background = [1, 1, 1];
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
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error(gl.getProgramInfoLog(program));
    const uniforms = {};
    for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; --i) {
      const { name } = gl.getActiveUniform(program, i);
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms, at: name => gl.getAttribLocation(program, name) };
  }

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

  palette() {
    const gl = this.gl, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
  }

  // Colours with a fourth number; for lines: hidden 0, shown 128, lit 255.
  fill(texture, colours) {
    const gl = this.gl, rows = Math.max(1, Math.ceil(colours.length / PALETTE_WIDTH));
    const data = new Uint8Array(4 * PALETTE_WIDTH * rows);
    colours.forEach((colour, i) => data.set(colour, 4 * i));
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, PALETTE_WIDTH, rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, data);
    this.draw();
  }

  addSurface(surface) {
    const gl = this.gl, { at } = this.programs.surface, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    this.buffer(surface.points);
    this.attribute(at('point'), 3, gl.UNSIGNED_SHORT, 8);
    this.buffer(surface.normals);
    this.attribute(at('normal'), 3, gl.BYTE, 4);
    if (surface.partOf) {
      this.buffer(Uint32Array.from(surface.partOf));
      this.attribute(at('part'), 1, gl.UNSIGNED_INT, 4);
    } else {
      gl.vertexAttribI4ui(at('part'), 0, 0, 0, 0);
    }
    const full = this.indices(surface.triangles);
    const coarse = this.indices(coarseTriangles(surface.points, surface.triangles, surface.partOf));
    gl.bindVertexArray(null);
    const { points, triangles } = surface;
    this.surfaces.push({ array, full, coarse, points, triangles, palette: this.palette() });
  }

  indices(triangles) {
    return { buffer: this.buffer(triangles, this.gl.ELEMENT_ARRAY_BUFFER), count: triangles.length };
  }

  setLines(points) {
    this.lines = { full: this.pointTexture(points), coarse: this.pointTexture(coarseLines(points)),
                   points, palette: this.palette(), nothing: this.gl.createVertexArray() };
  }

  pointTexture(points) {
    const gl = this.gl, texture = this.palette(), count = points.length / 4;
    const rows = Math.max(1, Math.ceil(count / PALETTE_WIDTH));
    const data = new Uint32Array(4 * PALETTE_WIDTH * rows);
    data.set(points);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32UI, PALETTE_WIDTH, rows, 0, gl.RGBA_INTEGER,
                  gl.UNSIGNED_INT, data);
    return { texture, count };
  }

  // By steps from where its points were.
  shiftLine(line, home, shift) {
    for (let i = line.first; i <= line.last; ++i)
      for (let k = 0; k < 3; ++k) {
        const place = Math.max(0, Math.min(STEPS, Math.round(stepsOf(home, i, k) + shift[k])));
        this.lines.points[4 * i + k] = home[4 * i + k] - stepsOf(home, i, k) + place;
      }
  }

  refillLines() {
    for (const [detail, points] of [['full', this.lines.points], ['coarse', coarseLines(this.lines.points)]]) {
      this.gl.deleteTexture(this.lines[detail].texture);
      this.lines[detail] = this.pointTexture(points);
    }
    this.draw();
  }

  pointOfLine(i) {
    return [0, 1, 2].map(k => stepsOf(this.lines.points, i, k) * this.scale[k] + this.shift[k]);
  }

  // Pixels of the canvas' own, from the upper left, or null behind the eye.
  project(place) {
    const { columns: m } = this.camera.matrix();
    const [x, y, , w] = [0, 1, 2, 3].map(r => m[r] * place[0] + m[4 + r] * place[1] + m[8 + r] * place[2] + m[12 + r]);
    return w > 0 ? [(x / w + 1) / 2 * this.canvas.clientWidth, (1 - y / w) / 2 * this.canvas.clientHeight] : null;
  }

  // Soon, and once, however often it is asked for.
  draw() {
    if (!this.isDue)
      requestAnimationFrame(() => {
        this.isDue = false;
        this.drawNow();
      });
    this.isDue = true;
  }

  drawNow() {
    const began = performance.now();
    this.detail = this.isMoving && this.isSlow ? 'coarse' : 'full';
    this.paint();
    if (this.detail === 'full') {
      this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits
      this.isSlow = performance.now() - began > 100;
    }
  }

  // Soon again, and in full when it has come to rest.
  move() {
    this.isMoving = true;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.isMoving = false;
      this.draw();
    }, 250);
    this.draw();
  }

  paint() {
    const gl = this.gl, ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height)
      Object.assign(this.canvas, { width, height });
    this.frame = [width, height];
    this.camera.aspect = width / height;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    gl.clearColor(...this.background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    const isOverBones = this.hasBones && this.detail === 'full' && this.opacity < 1;
    if (isOverBones)
      this.drawBones();
    this.drawSurfaces();
    this.drawLines(isOverBones);
  }

  use(program) {
    const gl = this.gl, { uniforms } = program, { columns, eye, near } = this.camera.matrix();
    gl.useProgram(program.program);
    gl.uniformMatrix4fv(uniforms.matrix, false, columns);
    gl.uniform3fv(uniforms.scale, this.scale);
    gl.uniform3fv(uniforms.shift, this.shift);
    gl.uniform3fv(uniforms.eye, eye);
    if (uniforms.near)
      gl.uniform1f(uniforms.near, near);
    return uniforms;
  }

  // A transparent surface: what looks away first, then the nearest that looks to the eye over it.
  drawSurfaces() {
    const gl = this.gl;
    if (this.opacity >= 1 || this.detail === 'coarse')
      return this.drawSurface(1);
    gl.enable(gl.CULL_FACE);
    gl.cullFace(gl.FRONT);
    this.drawSurface(this.opacity, true);
    gl.disable(gl.CULL_FACE);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.colorMask(false, false, false, false);
    this.drawSurface(1);
    gl.colorMask(true, true, true, true);
    this.drawSurface(this.opacity, true);
  }

  drawSurface(opacity, isBlended = false) {
    const gl = this.gl, surface = this.surfaces[this.shown];
    const uniforms = this.use(this.programs.surface);
    gl.uniform4fv(uniforms.cut, this.cutPlane());
    gl.uniform3fv(uniforms.right, this.camera.right);
    gl.uniform3fv(uniforms.up, this.camera.up);
    gl.uniform1f(uniforms.opacity, opacity);
    gl.bindTexture(gl.TEXTURE_2D, surface.palette);
    gl.bindVertexArray(surface.array);
    const { buffer, count } = surface[this.detail];
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    (isBlended ? gl.enable : gl.disable).call(gl, gl.BLEND);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    gl.disable(gl.POLYGON_OFFSET_FILL);
  }

  // A side of the box, or the picture's own plane; what lies beyond is not drawn.
  cutPlane() {
    const { axis, part, flipped } = this.cut;
    const sign = flipped ? -1 : 1;
    if (part >= 1)
      return [0, 0, 0, 1];
    const normal = axis === 3 ? this.camera.back : [0, 1, 2].map(i => i === axis ? 1 : 0);
    const half = axis === 3 ? 1 : this.size[axis] / 2;
    return [...scaled(normal, sign), half * (2 * part - 1)];
  }

  // What lies inside, solid: before the surface is laid over it, and where it looks out after that.
  drawBones() {
    const gl = this.gl;
    gl.disable(gl.BLEND);
    gl.depthMask(true);
    this.isRound = true;
    this.drawSegments(gl.LEQUAL, 0, 1);
    this.isRound = false;
  }

  // Hidden ones pale, and the paler the more there are; the stencil keeps each pixel to one of them.
  // None covers depth: the faint rim of a segment would hide the next one.
  drawLines(isOverBones) {
    if (!this.lines)
      return;
    const gl = this.gl, crowd = Math.min(1, Math.sqrt(30 / Math.max(1, this.numberShown)));
    gl.enable(gl.BLEND);
    gl.depthMask(false);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    gl.stencilFunc(gl.EQUAL, 0, 255);
    if (this.isAnyLit)
      this.drawSegments(gl.GREATER, 1, 0.65);
    if (!isOverBones)
      this.drawSegments(gl.GREATER, 0, (0.34 + 0.5 * (1 - this.opacity)) * crowd);
    gl.disable(gl.STENCIL_TEST);
    if (isOverBones)
      this.drawBones();
    else
      this.drawSegments(gl.LEQUAL, 0, 1);
    if (this.isAnyLit)
      this.drawSegments(gl.LEQUAL, 1, 1);
    gl.depthMask(true);
  }

  drawSegments(depth, wanted, strength, extra = 0) {
    const gl = this.gl, uniforms = this.use(this.programs.line);
    gl.uniform2fv(uniforms.size, this.frame);
    gl.uniform1f(uniforms.width, this.lineWidth * (window.devicePixelRatio || 1) + extra);
    gl.uniform1f(uniforms.strength, strength);
    gl.uniform1i(uniforms.wanted, wanted);
    const { depth: factor, offset } = this.camera.matrix();
    const pixels = this.frame[1] / 2 / this.camera.extent[1]; // of a unit of length, at the depth 1
    gl.uniform1f(uniforms.thick, this.isThick && this.isRound ? Math.max(...this.scale) * pixels : 0);
    gl.uniform3f(uniforms.round, factor, offset, this.isRound ? pixels : 0);
    const { texture, count } = this.lines[this.detail === 'coarse' ? 'coarse' : 'full'];
    gl.uniform1i(uniforms.points, 1);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.lines.palette);
    gl.bindVertexArray(this.lines.nothing);
    gl.depthFunc(depth);
    gl.drawArrays(gl.TRIANGLES, 0, 6 * Math.max(0, count - 1));
  }

  // Looks at lines from where most of them is seen and the eye is outside: small pictures tell. It
  // stays where it is if that is about as good, and tries fewer places where drawing takes long.
  lookAt(lines, place, radius) {
    const { camera, frame, lineWidth } = this, { back, right, up, aspect } = camera, steps = [-1, 0, 1];
    camera.lookAt(place, radius);
    this.lineWidth = 1 / (window.devicePixelRatio || 1);
    this.frame = [0, 1].map(i => Math.min(160, frame[i]));
    camera.aspect = this.frame[0] / this.frame[1];
    this.surfaces[this.shown].near = this.trianglesNear(place, camera.distance + radius);
    this.detail = 'near';
    let most = 1.2 * this.seen(lines), best = null;
    for (const side of steps.flatMap(x => steps.flatMap(y => steps.map(z => [x, y, z])))) {
      const square = dot(side, side);
      if (square === 0 || square === 2 && this.isSlow)
        continue;
      camera.lookFrom(normalized(side));
      const seen = this.seen(lines);
      if (seen > most)
        [most, best] = [seen, camera.back];
    }
    Object.assign(camera, { back, right, up, aspect });
    if (best)
      camera.lookFrom(best);
    Object.assign(this, { frame, lineWidth });
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
  }

  // How well lines are seen: less where insides are seen, too, as from an eye that is inside.
  seen(lines) {
    const gl = this.gl, [width, height] = this.frame, pixels = new Uint8Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.pickingTarget());
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.drawSurface(-1);
    this.drawSegments(gl.LEQUAL, 2, 1);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const counts = new Map(lines.map(line => [line + 1, 0]));
    let insides = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      const number = pixels[i] + 256 * pixels[i + 1] + 65536 * pixels[i + 2];
      if (counts.has(number))
        counts.set(number, counts.get(number) + 1);
      insides += number === 0 && pixels[i + 3] > 0 ? 1 : 0;
    }
    return [...counts.values()].reduce((s, n) => s + Math.sqrt(n), 0) * (1.01 - insides / width / height);
  }

  // Of many triangles those that can hide a place from an eye at a distance.
  trianglesNear(place, distance) {
    const { full, coarse, points, triangles } = this.surfaces[this.shown], most = 6e5, near = [];
    if (full.count < most)
      return full;
    for (let i = 0; i < triangles.length && near.length < most; i += 3) {
      let square = 0;
      for (let k = 0; k < 3; ++k)
        square += (points[4 * triangles[i] + k] * this.scale[k] + this.shift[k] - place[k]) ** 2;
      if (square < (distance + 0.02) ** 2)
        near.push(triangles[i], triangles[i + 1], triangles[i + 2]);
    }
    if (near.length >= most)
      return coarse;
    this.gl.bindVertexArray(null);
    this.gl.deleteBuffer(this.nearBuffer);
    const indices = this.indices(Uint32Array.from(near));
    this.nearBuffer = indices.buffer;
    return indices;
  }

  // The line at a pixel of the canvas: one that is seen, else one behind the surface, else -1.
  pick(x, y) {
    const gl = this.gl, ratio = window.devicePixelRatio || 1, reach = Math.round(6 * ratio);
    const target = this.pickingTarget();
    this.detail = 'full';
    const column = Math.round(x * ratio) - reach, row = this.canvas.height - Math.round(y * ratio) - reach;
    let found = -1;
    for (const isSurfaceThere of [true, false]) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, target);
      gl.viewport(0, 0, this.canvas.width, this.canvas.height);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(column, row, 2 * reach + 1, 2 * reach + 1);
      gl.colorMask(false, false, false, false);
      if (isSurfaceThere)
        this.drawSurface(1);
      gl.colorMask(true, true, true, true);
      gl.disable(gl.BLEND);
      this.drawSegments(gl.LEQUAL, 2, 1);
      gl.disable(gl.SCISSOR_TEST);
      found = this.nearestNumber(column, row, reach);
      if (found >= 0)
        break;
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return found;
  }

  nearestNumber(column, row, reach) {
    const gl = this.gl, side = 2 * reach + 1, pixels = new Uint8Array(4 * side * side);
    gl.readPixels(column, row, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let found = -1, nearest = Infinity;
    for (let i = 0; i < side * side; ++i) {
      const number = pixels[4 * i] + 256 * pixels[4 * i + 1] + 65536 * pixels[4 * i + 2];
      const distance = Math.hypot(i % side - reach, Math.floor(i / side) - reach);
      if (number > 0 && distance < nearest)
        [found, nearest] = [number - 1, distance];
    }
    return found;
  }

  pickingTarget() {
    const gl = this.gl, { width, height } = this.canvas;
    if (!this.target || this.target.width !== width || this.target.height !== height) {
      if (this.target)
        [this.target.colour, this.target.depth].forEach(b => gl.deleteRenderbuffer(b));
      const framebuffer = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      const attach = (format, place) => {
        const buffer = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
        gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
        return buffer;
      };
      this.target = { framebuffer, width, height,
                      colour: attach(gl.RGBA8, gl.COLOR_ATTACHMENT0),
                      depth: attach(gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT) };
    }
    return this.target.framebuffer;
  }
}
