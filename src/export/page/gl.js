// The picture, by the shaders of saddle itself, in the order of render/picture/renderer.cpp. Each
// pixel has two samples each way, unless the screen's own pixels are as small.

function glPainter(canvas) {
  const options = {antialias: devicePixelRatio > 1.5, preserveDrawingBuffer: true, alpha: true, premultipliedAlpha: true};
  const gl = canvas.getContext('webgl2', options);
  if (!gl) return null;
  let programs, maps, indices;

  function link([vertex, fragment]) {
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, '#version 300 es\nprecision highp float;precision highp int;precision highp sampler2D;\n' + text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw Error(gl.getProgramInfoLog(program) + gl.getAttachedShaders(program).map(s => gl.getShaderInfoLog(s)));
    }
    const uniforms = {};
    for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); i-- > 0;) {
      const {name, type} = gl.getActiveUniform(program, i);
      uniforms[name.replace('[0]', '')] = [gl.getUniformLocation(program, name), type];
    }
    return {program, uniforms};
  }

  function use({program, uniforms}, values) {
    gl.useProgram(program);
    for (const name in uniforms) {
      const [at, type] = uniforms[name], value = values[name];
      if (type == gl.FLOAT) gl.uniform1fv(at, [].concat(value));
      else if (type == gl.FLOAT_VEC3) gl.uniform3fv(at, value.flat());
      else if (type == gl.FLOAT_MAT3) gl.uniformMatrix3fv(at, false, value);
      else if (type == gl.FLOAT_MAT4) gl.uniformMatrix4fv(at, false, value);
      else gl.uniform1i(at, value);
    }
  }

  function start() {
    programs = scene.programs.map(link);
    maps = scene.maps.map(bytes => {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, 256, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, bytes);
      for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) {
        gl.texParameteri(gl.TEXTURE_2D, name, value);
      }
      return texture;
    });
    indices = gl.createBuffer();
    for (const s of scene.surfaces) {
      s.buffers = null;
      s.map = s.colored ? maps[s.scale] : s.texture?.picture >= 0 ? glPicture(gl, s.texture) : null;
    }
    box = null;
  }

  // A vertex array with these attributes: [location, size, numbers, stride, offset, divisor].
  function vertexArray(attributes, elements) {
    const array = gl.createVertexArray();
    const buffers = new Map();
    gl.bindVertexArray(array);
    for (const [location, size, numbers, stride, offset, divisor] of attributes) {
      if (!buffers.has(numbers)) buffers.set(numbers, gl.createBuffer());
      gl.bindBuffer(gl.ARRAY_BUFFER, buffers.get(numbers));
      gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, 4 * stride, 4 * offset);
      gl.vertexAttribDivisor(location, divisor);
    }
    if (elements) {
      buffers.set(elements, gl.createBuffer());
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers.get(elements));
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, elements, gl.STATIC_DRAW);
    }
    return {array, buffers, count: elements ? elements.length : 0};
  }

  function strokes(chains, frame) {
    const numbers = [];
    const model = p => frame.centre.map((x, k) => (p[k] - x) / frame.size);
    for (const chain of chains) {
      chain.forEach((p, i) => {
        if (i || chain.length == 1) numbers.push(...model(chain[Math.max(i - 1, 0)]), ...model(p));
      });
    }
    const floats = new Float32Array(numbers);
    return {...vertexArray([0, 5, 6, 8].map((at, i) => [at, 3, floats, 6, i % 2 * 3, 1])), count: numbers.length / 6};
  }

  function upload(s) {
    const {centre, size} = s.frame, p = s.position;
    for (const old of s.buffers ? Object.values(s.buffers) : []) {
      gl.deleteVertexArray(old.array);
      old.buffers.forEach(buffer => gl.deleteBuffer(buffer));
    }
    const attributes = [[0, 3, Float32Array.from(p, (x, i) => (x - centre[i % 3]) / size), 0, 0, 0],
      [1, 3, Float32Array.from(s.normal), 0, 0, 0]];
    if (s.colored) attributes.push([3, 1, Float32Array.from(s.numbers[0], x => share(s, x)), 0, 0, 0]);
    if (s.texture) attributes.push([7, 2, placesOf(s), 0, 0, 0]);
    const at = i => p.subarray(3 * i, 3 * i + 3);
    s.buffers = {
      faces: vertexArray(attributes, s.drawn),
      lines: strokes(s.chains.map(chain => chain.map(at)).filter(chain => chain.every(q => isFinite(q[0] + q[1] + q[2]))), s.frame),
      contours: strokes(s.contours, s.frame),
    };
    s.stale = false;
  }

  let box;
  function drawStrokes(lines, toClip, width, color, c) {
    if (!lines.count) return;
    use(programs[0], {model_to_clip: toClip, line_color: color,
      half_size: [canvas.width / 2, canvas.height / 2, width * canvas.height / c.height / 2]});
    gl.bindVertexArray(lines.array);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, lines.count);
  }

  // Back to front: see-through triangles blend in this order.
  function sorted(s, toEye) {
    const [x, y, z] = [toEye[2], toEye[6], toEye[10]], {centre, size} = s.frame, t = s.drawn, p = s.position;
    const depth = i => x * (p[3 * i] - centre[0]) + y * (p[3 * i + 1] - centre[1]) + z * (p[3 * i + 2] - centre[2]);
    const keys = Float64Array.from({length: t.length / 3}, (_, i) => depth(t[3 * i]) + depth(t[3 * i + 1]) + depth(t[3 * i + 2]));
    const order = Array.from(keys.keys()).sort((a, b) => keys[a] - keys[b]);
    return Uint32Array.from(t, (_, i) => t[3 * order[Math.floor(i / 3)] + i % 3]);
  }

  function drawFaces({s, placed}, lights, clear) {
    const {toEye, toClip, normals, mirrored} = placed;
    use(programs[s.program], {...lights, ...s.look, model_to_clip: toClip, model_to_eye: toEye, normal_to_eye: normals,
      colormap: 0, color_scale: s.onScale[0], color_offset: s.onScale[1],
      picture: 0, texture_scale: s.texture?.scale});
    if (s.map) gl.bindTexture(gl.TEXTURE_2D, s.map);
    gl.frontFace(mirrored ? gl.CW : gl.CCW);
    gl.bindVertexArray(s.buffers.faces.array);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, clear ? indices : s.buffers.faces.buffers.get(s.drawn));
    if (clear) gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, sorted(s, toEye), gl.DYNAMIC_DRAW);
    gl.drawElements(gl.TRIANGLES, s.drawn.length, gl.UNSIGNED_INT, 0);
  }

  function draw(view) {
    const {c, items, lights, edges} = view;
    const per = canvas.height / c.height;
    for (const s of scene.surfaces) if (s.stale || !s.buffers) upload(s);
    const array = {};
    for (const light of lights) for (const name in light) (array[name] ||= []).push(light[name]);
    for (const name of ['light_color', 'light_highlight', 'light_ambient']) {
      if (scene.grey && array[name]) array[name] = array[name].map(x => x[0]);
    }
    const [r, g, b, a] = scene.background;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(r * a, g * a, b * a, a);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const placedItems = items.map(({s, matrix}) => ({s, matrix, placed: place(s, matrix, c)}));
    const wide = Math.max(...scene.surfaces.map(s => s.look.line_width || 1));
    gl.polygonOffset(wide * per + 1, 1);  // enough for level lines, half of which lie on one side
    if (scene.surfaces.some(s => s.chains.length || s.contours.length)) gl.enable(gl.POLYGON_OFFSET_FILL);
    const faces = placedItems.filter(({s}) => s.drawn.length && s.look.opacity > 0);
    for (const item of faces) if (item.s.look.opacity >= 1) drawFaces(item, array, false);
    gl.disable(gl.POLYGON_OFFSET_FILL);
    for (const {s, matrix, placed} of placedItems) {
      const {line_width: width, line_color: color} = s.look;
      if (s.stroke) {  // nearer than what it lies on
        const nearer = (width + 2) * 2 / c.height * c.half;
        const clip = c.toClip.slice();
        if (c.ortho) clip[14] += clip[10] * nearer;
        else for (let i = 0; i < 12; ++i) clip[i] *= 1 - nearer / c.distance;
        const there = place(s, matrix, {...c, toClip: clip});
        if (!s.drawn.length) drawStrokes(s.buffers.lines, there.toClip, width, color, c);
      } else {
        if (view.grid) drawStrokes(s.buffers.lines, placed.toClip, width, color, c);
        drawStrokes(s.buffers.contours, placed.toClip, width * s.look.wider, s.look.levels, c);
      }
    }
    if (edges.length) {
      const frame = {centre: c.target, size: c.distance};
      const s = {frame};
      const lines = strokes(edges, frame);
      drawStrokes(lines, place(s, diagonal([1, 1, 1]), c).toClip, view.line, scene.ink.map(x => 0.35 + 0.3 * x), c);
      gl.deleteVertexArray(lines.array);
      lines.buffers.forEach(buffer => gl.deleteBuffer(buffer));
    }
    const clear = faces.filter(({s}) => s.look.opacity < 1);
    if (clear.length) {
      gl.enable(gl.BLEND);
      gl.depthMask(false);
      gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      clear.sort((p, q) => p.placed.toEye[14] - q.placed.toEye[14]).forEach(item => drawFaces(item, array, true));
      gl.depthMask(true);
      gl.disable(gl.BLEND);
    }
  }

  start();
  canvas.addEventListener('webglcontextlost', event => event.preventDefault());
  canvas.addEventListener('webglcontextrestored', () => { start(); changed(); });
  return {draw, scale: options.antialias ? 1 : 2, coarse: 0.5, isLost: () => gl.isContextLost()};
}
