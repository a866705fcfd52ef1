// The surface on a canvas: merged polygons, and classic Marching Cubes beside them if wanted; or a mesh.
import { Geometry, Mat4, Mesh, Program, Renderer } from 'ogl';
import { asTheyAre, Camera } from './camera.js';
import { facing } from './facing.js';
import { kindBases, litPlanes, plainBases, planesOf, whiteBases } from './light.js';
import * as palette from './palette.js';
import * as shaders from './shaders.js';
import { record } from './timing.js';

/** The offset of polygons, so that neighbours differ. */
const tints = [palette.bone, palette.skyBlue, palette.orange, palette.green, palette.yellow, palette.purple,
  palette.vermilion].map(palette.rgb);
const noTints = tints.map(() => [1, 1, 1]);

const nowhere = [0, 0, 0, 1]; // a cut beyond which nothing lies
const finest = 2; // pixels of the picture to one of the page
const missingWidth = 2; // of lines, in pixels of the page
const restful = 250; // milliseconds without a change until the picture is made finer

export class SurfaceView {
  /** Throws where the browser has no WebGL 2. @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.start();
    if (!this.renderer.isWebgl2) throw new Error('This browser has no WebGL 2.');
    this.camera = new Camera(this.gl);
    this.isDue = false;
    this.isDrawing = false;
    this.isFinal = false;
    this.scale = 1;
    this.hasEdges = false;
    /** @type {{axis: number, at: number} | null} */ this.cut = null;
    /** @type {Mesh | null} */ this.surface = null;
    /** @type {Mesh | null} */ this.edges = null;
    /** @type {Mesh | null} */ this.classic = null;
    /** @type {Mesh | null} */ this.classicEdges = null;
    /** @type {Mesh | null} */ this.marks = null;
    /** @type {Mesh | null} */ this.missing = null;
    this.programs = this.makePrograms();
    // Else it would be lost for good.
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => this.restore());
    this.setSpace({ dims: [1, 1, 1], spacing: [1, 1, 1] }, true);
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  start() {
    const { canvas } = this;
    this.renderer = new Renderer({ canvas, webgl: 2, antialias: false, alpha: true });
    canvas.style.width = canvas.style.height = ''; // the style sheet's
    this.gl = this.renderer.gl;
  }

  /** The graphics card has forgotten all that it had, as after sleep or a new driver. */
  restore() {
    this.start();
    this.programs = this.makePrograms();
    // What there was is not removed: it is no more.
    this.surface = this.edges = this.classic = this.classicEdges = this.marks = this.missing = null;
    this.next ??= this.shown;
    this.setClassic(this.shownClassic);
    this.setMarks(this.shownMarks);
    this.setMissing(this.shownMissing);
  }

  makePrograms() {
    /** The uniforms of all programs; see shaders.js. */
    this.uniforms ??= {
      toClip: { value: new Mat4() },
      toView: { value: new Array(9).fill(0) },
      cut: { value: nowhere },
      toPlace: { value: [1, 1, 1] },
      isMirrored: { value: false },
      planes: { value: planesOf([1, 1, 1]) },
      bases: { value: plainBases },
      outer: { value: planesOf([1, 1, 1]) },
      inner: { value: planesOf([1, 1, 1]) },
      tints: { value: noTints },
      plain: { value: palette.rgb(palette.bone) },
      isFlat: { value: false },
    };
    this.edgeLine = { value: [0.05, 0.05, 0.08, 1] };
    const program = (/** @type {string} */ vertex, /** @type {string} */ fragment,
      /** @type {object} */ uniforms = {}, /** @type {object} */ options = {}) =>
      new Program(this.gl, { vertex, fragment, cullFace: false, ...options,
        uniforms: { ...this.uniforms, ...uniforms } });
    const dark = { line: this.edgeLine };
    this.halfWidth = { value: [1, 1] };
    const faintly = { line: { value: [...palette.rgb(palette.vermilion), 0.4] } };
    const marking = { line: { value: [...palette.rgb(palette.vermilion), 1] } };
    const hidden = (/** @type {boolean} */ isOpen) => {
      const lines = program(shaders.wideLineVertex, shaders.lineFragment(isOpen),
        { ...faintly, halfWidth: this.halfWidth }, { transparent: true, depthTest: false });
      lines.setBlendFunc(this.gl.ONE, this.gl.ONE_MINUS_SRC_ALPHA);
      return lines;
    };
    const programsFor = (/** @type {boolean} */ isOpen) => ({
      flat: program(shaders.flatVertex(isOpen), shaders.flatFragment(isOpen)),
      smooth: program(shaders.smoothVertex, shaders.smoothFragment(isOpen)),
      mesh: program(shaders.meshVertex, shaders.meshFragment(isOpen)),
      classic: program(shaders.classicVertex, shaders.classicFragment(isOpen)),
      edges: program(shaders.edgeVertex, shaders.lineFragment(isOpen), dark, { transparent: true }),
      meshEdges: program(shaders.meshEdgeVertex, shaders.lineFragment(isOpen), dark,
        { transparent: true }),
      classicEdges: program(shaders.lineVertex, shaders.lineFragment(isOpen), dark,
        { transparent: true }),
      missing: program(shaders.wideLineVertex, shaders.lineFragment(isOpen),
        { ...marking, halfWidth: this.halfWidth }),
      hiddenMissing: hidden(isOpen),
      marks: program(shaders.lineVertex, shaders.lineFragment(false), marking,
        { depthTest: false }),
    });
    return { closed: programsFor(false), open: programsFor(true) };
  }

  /**
   * The space that surfaces are in.
   * @param {{dims: number[], spacing: number[], upright?: number[][], origin?: number[]}} volume
   *   origin: where a mesh has its lowest corner
   * @param {boolean} isClosed whether no inside is seen
   * @param {boolean} [isGrowing] whether there will be more of the surface than there is at first
   */
  setSpace({ dims, spacing, upright = asTheyAre, origin = [0, 0, 0] }, isClosed, isGrowing = false) {
    this.origin = origin;
    this.dims = dims;
    this.spacing = spacing;
    this.isClosed = isClosed;
    this.isGrowing = isGrowing;
    this.uniforms.planes.value = planesOf(spacing);
    this.uniforms.toPlace.value = spacing.map((step) => 2 / step);
    this.uniforms.isMirrored.value = spacing[0] * spacing[1] * spacing[2] < 0;
    this.centre = dims.map((extent, i) => ((extent - 1) / 2) * spacing[i]);
    this.camera.upright = upright;
    this.camera.depth = Math.hypot(...dims.map((extent, i) => extent * spacing[i]));
    this.removed(this.surface, this.edges);
    this.surface = this.edges = this.vertices = this.shown = null;
    this.home();
  }

  /** Shows the whole surface, or all of its space where there is none. */
  home() {
    const { low, high } = this.vertices?.length && !this.isGrowing ? boxOf(this.vertices, this.stride)
      : { low: [-1, -1, -1], high: this.dims.map((extent) => 2 * extent - 1) };
    const size = low.map((from, i) => ((high[i] - from) / 2) * this.spacing[i]);
    const middle = low.map((from, i) => ((high[i] + from) / 4) * this.spacing[i] - this.centre[i]);
    this.camera.reset(Math.hypot(...size) / 2 || 1, middle);
    this.draw();
  }

  /**
   * Shows other polygons, or a mesh of them, once the picture under way is drawn; those that come meanwhile take
   * their place. Owner: the arrays are the view's from here on.
   * @param {{vertices: Uint8Array, triangles: Uint8Array, triangleEnds: Uint8Array,
   *   edges: Uint8Array | null, normals: Uint8Array | null} |
   *   {places: Float32Array, normals: Float32Array, colours: Uint8Array, triangles: Uint32Array}} surface
   */
  setSurface(surface) {
    this.next = surface;
    this.draw();
  }

  /** A mesh, as setSurface(). @param {import('./formats/glb.js').DrawnMesh} mesh */
  setMesh(mesh) {
    this.next = mesh;
    this.draw();
  }

  /** @param {boolean} isFlat whether a mesh is drawn without its normals */
  setFlat(isFlat) {
    this.uniforms.isFlat.value = isFlat;
    this.draw();
  }

  /** @param {import('./formats/glb.js').DrawnMesh} mesh */
  uploadMesh({ places, normals, colours, triangles }) {
    const gl = this.gl;
    this.vertices = places;
    this.triangles = triangles;
    this.surface = this.mesh(new Geometry(gl, {
      position: { data: places, size: 3 },
      normal: { data: normals ?? new Float32Array(places.length), size: 3 },
      colour: { data: colours, size: 4, type: gl.UNSIGNED_BYTE, normalized: true },
      index: { data: triangles },
    }), gl.TRIANGLES, this.spacing.map((step) => step / 2));
  }

  /** @param {any} surface */
  upload(surface) {
    this.shown = surface;
    this.removed(this.surface, this.edges);
    this.edges = null;
    this.isMesh = surface.places !== undefined;
    this.stride = this.isMesh ? 3 : 4;
    if (this.isMesh) return this.uploadMesh(surface);
    const { vertices, triangles, triangleEnds, edges, normals } = surface;
    this.vertices = new Int16Array(vertices.buffer);
    this.triangles = new Uint32Array(triangles.buffer);
    this.triangleEnds = new Uint32Array(triangleEnds.buffer);
    const gl = this.gl;
    const position = { data: this.vertices, size: 4, type: gl.SHORT, normalized: true };
    const geometry = new Geometry(gl, { position });
    if (normals)
      geometry.addAttribute('octahedral', { data: normals, size: 2, type: gl.UNSIGNED_BYTE,
        normalized: true });
    this.isSmooth = normals !== null;
    geometry.setIndex({ data: this.triangles });
    this.surface = this.mesh(geometry, gl.TRIANGLES, this.perUnit());
    if (edges) {
      const index = { data: new Uint32Array(edges.buffer) };
      this.edges = this.mesh(new Geometry(gl, { position: { ...position }, index }), gl.LINES,
        this.perUnit());
    }
  }

  /** @param {{vertices: Uint8Array, triangles: Uint8Array} | null} classic */
  setClassic(classic) {
    this.shownClassic = classic;
    this.removed(this.classic, this.classicEdges);
    this.classic = this.classicEdges = null;
    if (classic) {
      const gl = this.gl;
      const position = { data: new Float32Array(classic.vertices.buffer), size: 3 };
      this.classicTriangles = new Uint32Array(classic.triangles.buffer);
      const index = { data: this.classicTriangles };
      this.classic = this.mesh(new Geometry(gl, { position, index }), gl.TRIANGLES, [1, 1, 1]);
    }
    this.draw();
  }

  /** Leaves out what lies beyond a voxel along an axis. @param {{axis: number, at: number} | null} cut */
  setCut(cut) {
    this.cut = cut;
    this.uniforms.cut.value = cut
      ? [0, 1, 2].map((i) => (i === cut.axis ? 1 : 0)).concat(2 * cut.at) : nowhere;
    this.draw();
  }

  /** @param {number} colouring 0 plain, 1 by the kind of plane, 2 by polygon */
  setColouring(colouring) {
    this.uniforms.bases.value = [plainBases, kindBases, whiteBases][colouring];
    this.uniforms.tints.value = colouring === 2 ? tints : noTints;
    this.draw();
  }

  /**
   * Lines around what is missing; faint where the surface hides them.
   * @param {Uint8Array | null} lines as Module.missing() has them
   */
  setMissing(lines) {
    this.shownMissing = lines;
    this.removed(this.missing);
    this.missing = null;
    if (lines?.length) {
      const gl = this.gl;
      const corner = { data: new Float32Array([0, -1, 0, 1, 1, -1, 1, 1]), size: 2 };
      const numbers = { data: new Int16Array(lines.buffer), size: 3, type: gl.SHORT, stride: 12,
        instanced: 1 };
      const geometry = new Geometry(gl, { corner, from: { ...numbers, offset: 0 },
        to: { ...numbers, offset: 6 } });
      this.missing = this.mesh(geometry, gl.TRIANGLE_STRIP, this.spacing.map((step) => step / 2));
    }
    this.draw();
  }

  /** Lines between points, over all. @param {number[][]} points in millimetres of the volume */
  setMarks(points) {
    this.shownMarks = points;
    this.removed(this.marks);
    this.marks = null;
    if (points.length > 0) {
      const size = this.camera.radius / 60;
      const crosses = points.flatMap((point) => [0, 1, 2].flatMap((axis) => [-size, size].map((step) =>
        point.map((at, i) => (i === axis ? at + step : at)))));
      const all = points.length > 1 ? crosses.concat(points) : crosses;
      const data = new Float32Array(all.flat());
      this.marks = this.mesh(new Geometry(this.gl, { position: { data, size: 3 } }),
        this.gl.LINES, [1, 1, 1]);
    }
    this.draw();
  }

  /** Draws soon, once for all changes until then. */
  draw() {
    clearTimeout(this.resting);
    this.isFinal = false;
    this.ask();
  }

  ask() {
    if (this.isDue || this.isDrawing) {
      this.isDue = true;
      return;
    }
    this.isDue = true;
    requestAnimationFrame(() => {
      this.isDue = false;
      this.drawAndWait();
    });
  }

  // The next picture waits until the graphics card is done with this one: so none queues up.
  async drawAndWait() {
    if (this.gl.isContextLost()) return; // restore() draws
    this.isDrawing = true;
    const begin = performance.now();
    const { isFinal } = this;
    this.drawNow(isFinal ? finest : this.scale);
    await this.finished();
    const duration = performance.now() - begin;
    record('drawn', begin, duration, { isFinal });
    this.isDrawing = false;
    const [fast, slow] = [12, 60]; // milliseconds
    if (!isFinal && duration > slow) this.scale = Math.max(0.5, this.scale / 2);
    if (!isFinal && duration < fast) this.scale = Math.min(finest, 2 * this.scale);
    if (this.isDue) {
      this.isDue = false;
      this.ask();
    } else if (!isFinal) {
      this.resting = setTimeout(() => {
        this.isFinal = true;
        this.ask();
      }, this.scale < 1 ? 3 * restful : restful);
    }
  }

  /** Until what was asked of the graphics card is done. */
  async finished() {
    const gl = this.gl;
    const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const pending = () => !gl.isContextLost() &&
      gl.getSyncParameter(sync, gl.SYNC_STATUS) === gl.UNSIGNALED;
    // A task of its own each time: the browser reports the state of the card between tasks.
    do await new Promise((resolve) => setTimeout(resolve, 1));
    while (pending());
    gl.deleteSync(sync);
  }

  /** @param {number} scale pixels of the picture to one of the page */
  drawNow(scale) {
    const { gl, canvas, renderer } = this;
    if (this.next) {
      const isFirst = !this.vertices;
      this.upload(this.next);
      this.next = null;
      if (isFirst) this.home();
    }
    const width = Math.max(1, Math.round(canvas.clientWidth * scale));
    const height = Math.max(1, Math.round(canvas.clientHeight * scale));
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    renderer.bindFramebuffer();
    renderer.enable(gl.DEPTH_TEST);
    renderer.setDepthMask(true);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const part = this.classic ? Math.floor(width / 2) : width;
    const lens = this.camera.lensFor(part, height);
    const { uniforms } = this;
    const axes = this.camera.axes();
    // By columns: from space to right, upwards and towards the viewer.
    uniforms.toView.value = [0, 1, 2].flatMap((i) => [axes.x[i], axes.y[i], axes.z[i]]);
    uniforms.outer.value = litPlanes(uniforms.planes.value, uniforms.bases.value, axes, false);
    uniforms.inner.value = litPlanes(uniforms.planes.value, uniforms.bases.value, axes, true);
    const isOpen = this.cut !== null || !this.isClosed;
    const programs = isOpen ? this.programs.open : this.programs.closed;
    const surface = this.isMesh ? programs.mesh : this.isSmooth ? programs.smooth : programs.flat;
    surface.cullFace = programs.classic.cullFace = isOpen ? false : gl.BACK;
    const show = (/** @type {Mesh | null} */ mesh, /** @type {Program} */ program) => {
      if (!mesh) return;
      mesh.program = program;
      uniforms.toClip.value.multiply(lens.projectionViewMatrix, mesh.worldMatrix);
      mesh.draw({ camera: lens });
    };
    gl.viewport(0, 0, part, height);
    const parts = isOpen || this.isMesh || !this.surface ? [{ begin: 0, end: this.triangles?.length ?? 0 }]
      : facing(uniforms.planes.value, this.triangleEnds, this.camera.position(),
        this.dims.map((extent, i) => Math.abs((extent / 2) * this.spacing[i])));
    this.behindLines(() => parts.forEach(({ begin, end }) => {
      this.surface?.geometry.setDrawRange(begin, end - begin);
      show(this.surface, surface);
    }));
    // If voxels are small in the picture their many edges are fainter, so that they leave light.
    const pixels = Math.min(part, height) / scale / this.camera.millimetres();
    this.edgeLine.value[3] = Math.min(0.9, 0.12 * pixels * this.detail());
    if (this.hasEdges && this.isMesh && this.surface)
      this.edges ??= this.sides(this.surface, this.triangles, this.spacing.map((step) => step / 2));
    if (this.hasEdges) show(this.edges, this.isMesh ? programs.meshEdges : programs.edges);
    this.halfWidth.value = [missingWidth / part, missingWidth / height].map((width) => width * scale);
    show(this.missing, programs.hiddenMissing);
    show(this.missing, programs.missing);
    show(this.marks, programs.marks);
    if (!this.classic) return;
    gl.viewport(part, 0, part, height);
    this.behindLines(() => show(this.classic, programs.classic));
    if (!this.hasEdges) return;
    this.classicEdges ??= this.sides(this.classic, this.classicTriangles, [1, 1, 1]);
    show(this.classicEdges, programs.classicEdges);
  }

  /** How far edges are apart, about. Units: millimetres */
  detail() {
    return this.isMesh ? this.camera.depth / Math.sqrt(this.triangles.length)
      : Math.min(...this.spacing.map(Math.abs));
  }

  /** The sides of triangles. @param {Mesh} mesh @param {Uint32Array} triangles @param {number[]} scale */
  sides(mesh, triangles, scale) {
    const { position } = mesh.geometry.attributes;
    const geometry = new Geometry(this.gl,
      { position: { ...position }, index: { data: sidesOf(triangles) } });
    return this.mesh(geometry, this.gl.LINES, scale);
  }

  /** @param {() => void} show */
  behindLines(show) {
    const gl = this.gl;
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    show();
    gl.disable(gl.POLYGON_OFFSET_FILL);
  }

  /** The picture as PNG. @returns {Promise<Blob | null>} */
  picture() {
    this.drawNow(finest);
    return new Promise((resolve) => this.canvas.toBlob(resolve, 'image/png'));
  }

  /**
   * What is seen at a point of the canvas: its place in millimetres of the volume.
   * @param {number} right @param {number} up from -1 to 1 @returns {number[] | null}
   */
  pick(right, up) {
    if (!this.surface) return null;
    let [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    if (this.classic) {
      if (right > 0) return null;
      right = 2 * right + 1;
      width /= 2;
    }
    const { origin, direction } = this.camera.ray(right, up, width, height);
    const inSteps = (/** @type {number[]} */ v, /** @type {number[]} */ offset) =>
      v.map((at, i) => (2 * (at + offset[i])) / this.spacing[i]);
    const from = inSteps(origin, this.centre), way = inSteps(direction, [0, 0, 0]);
    const far = nearestHit(this.vertices, this.stride, this.triangles, from, way, this.cut);
    return far === null ? null : from.map((at, i) => ((at + far * way[i]) * this.spacing[i]) / 2);
  }

  /** Millimetres to what the shaders have of a vertex. */
  perUnit() {
    return this.spacing.map((step) => (step / 2) * shaders.vertexUnit);
  }

  /** @param {Geometry} geometry @param {number} mode @param {number[]} scale */
  mesh(geometry, mode, scale) {
    const mesh = new Mesh(this.gl, { geometry, mode });
    mesh.scale.set(scale[0], scale[1], scale[2]);
    mesh.position.set(-this.centre[0], -this.centre[1], -this.centre[2]);
    mesh.updateMatrixWorld();
    return mesh;
  }

  /** @param {...(Mesh | null)} meshes */
  removed(...meshes) {
    for (const mesh of meshes) mesh?.geometry.remove();
  }
}

/** @param {Int16Array | Float32Array} vertices @param {number} stride numbers each */
function boxOf(vertices, stride) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < vertices.length; i += stride)
    for (let axis = 0; axis < 3; ++axis) {
      const at = vertices[i + axis];
      if (at < low[axis]) low[axis] = at;
      if (at > high[axis]) high[axis] = at;
    }
  return vertices.length > 0 ? { low, high } : { low: [0, 0, 0], high: [0, 0, 0] };
}

/** The three sides of each triangle. @param {Uint32Array} triangles */
function sidesOf(triangles) {
  const sides = new Uint32Array(2 * triangles.length);
  for (let i = 0; i < triangles.length; i += 3)
    for (let side = 0; side < 3; ++side) {
      sides[2 * (i + side)] = triangles[i + side];
      sides[2 * (i + side) + 1] = triangles[i + ((side + 1) % 3)];
    }
  return sides;
}

/**
 * How far along a line its first triangle is: T. Moeller and B. Trumbore, Fast, Minimum Storage
 * Ray/Triangle Intersection, 1997.
 * @param {Int16Array | Float32Array} vertices @param {number} stride numbers a vertex
 * @param {Uint32Array} triangles
 * @param {number[]} from @param {number[]} way @param {{axis: number, at: number} | null | undefined} cut
 */
function nearestHit(vertices, stride, triangles, from, way, cut) {
  let nearest = Infinity;
  const [dx, dy, dz] = way;
  for (let i = 0; i < triangles.length; i += 3) {
    const a = stride * triangles[i], b = stride * triangles[i + 1], c = stride * triangles[i + 2];
    const ax = vertices[a], ay = vertices[a + 1], az = vertices[a + 2];
    const e1x = vertices[b] - ax, e1y = vertices[b + 1] - ay, e1z = vertices[b + 2] - az;
    const e2x = vertices[c] - ax, e2y = vertices[c + 1] - ay, e2z = vertices[c + 2] - az;
    const px = dy * e2z - dz * e2y, py = dz * e2x - dx * e2z, pz = dx * e2y - dy * e2x;
    const det = e1x * px + e1y * py + e1z * pz;
    if (det === 0) continue;
    const tx = from[0] - ax, ty = from[1] - ay, tz = from[2] - az;
    const u = (tx * px + ty * py + tz * pz) / det;
    if (u < 0 || u > 1) continue;
    const qx = ty * e1z - tz * e1y, qy = tz * e1x - tx * e1z, qz = tx * e1y - ty * e1x;
    const v = (dx * qx + dy * qy + dz * qz) / det;
    if (v < 0 || u + v > 1) continue;
    const far = (e2x * qx + e2y * qy + e2z * qz) / det;
    if (far <= 0 || far >= nearest) continue;
    if (cut && from[cut.axis] + far * way[cut.axis] > 2 * cut.at) continue;
    nearest = far;
  }
  return nearest === Infinity ? null : nearest;
}
