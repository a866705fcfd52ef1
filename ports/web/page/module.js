// The WebAssembly module: its calls with names, and its memory as typed arrays. Addresses come with
// a sign, and have none.
import { placeOf } from './formats/axes.js';

/** Owner of a volume or stream, and of its surface: see module/module.cpp. */
export class Module {
  /** @param {BufferSource | WebAssembly.Module} source */
  static async start(source) {
    const module = new Module();
    const started = await WebAssembly.instantiate(/** @type {any} */ (source), {
      page: {
        fail: (/** @type {number} */ text) => {
          throw new Error(module.textAt(text));
        },
        attempt: (/** @type {number} */ call, /** @type {number} */ context) =>
          module.attempt(call, context),
      },
      // Nothing is written or read; the C library has the calls all the same.
      wasi_snapshot_preview1: { fd_close: () => 8, fd_seek: () => 8, fd_write: () => 8 },
    });
    // Bytes give the module beside its instance.
    module.exports = /** @type {any} */ ((started.instance ?? started).exports);
    module.exports._initialize();
    module.hasVolume = false;
    module.stack = module.exports.__stack_pointer.value;
    return module;
  }

  /** Calls with the stack as it is at first: what was thrown from the last call left it full. */
  call(/** @type {string} */ name, /** @type {any[]} */ ...values) {
    this.exports.__stack_pointer.value = this.stack;
    return this.exports[name](...values);
  }

  /** Calls; what is thrown is dropped, and the stack is as before. */
  attempt(/** @type {number} */ call, /** @type {number} */ context) {
    const stack = this.exports.__stack_pointer.value;
    try {
      this.exports.__indirect_function_table.get(call)(context);
      return 1;
    } catch {
      this.exports.__stack_pointer.value = stack;
      return 0;
    }
  }

  /**
   * Makes room for a volume; returns where its samples go: valid until the next call.
   * @param {import('./formats/volume_info.js').VolumeInfo} info @param {number} type its number
   * @param {number} bytes
   */
  newVolume(info, type, bytes) {
    const at = this.call('new_volume', type, ...info.dims, ...info.spacing, info.slope,
      info.intercept, info.isInHounsfield ? 1 : 0);
    this.hasVolume = true;
    return new Uint8Array(this.exports.memory.buffer, at >>> 0, bytes);
  }

  /** The values of the volume. Costs a pass over it. */
  measure() {
    const bars = 256;
    const numbers = this.numbersAt(this.call('measure'), 9 + bars);
    const [least, greatest, dark, bright, automatic, otsu, bone, skin, count] = numbers;
    return {
      least, greatest, dark, bright, automatic, otsu, bone, skin, count,
      histogram: numbers.slice(9),
    };
  }

  /** Sweeps the volume. @param {number} iso @param {boolean} isFiltered */
  extract(iso, isFiltered) {
    const [cells, facets, classicTriangles, polygons, rings] =
      this.numbersAt(this.call('extract', iso, isFiltered ? 1 : 0), 5);
    return { cells, facets, classicTriangles, polygons, rings };
  }

  /** Triangulates what was swept or decoded. */
  draw() {
    const leftOut = this.call('draw');
    return {
      leftOut, vertices: this.copy('vertices'), triangles: this.copy('triangles'),
      triangleEnds: this.copy('triangle_ends'),
    };
  }
  edges() {
    return this.copy('edges');
  }
  normals() {
    return this.copy('normals');
  }
  /** The polygons as numbers: see save/jsonl.js. */
  polygons() {
    return new Int32Array(this.copy('polygons').buffer);
  }

  classic() {
    this.call('classic');
    return { vertices: this.copy('classic_vertices'), triangles: this.copy('classic_triangles') };
  }

  /** @param {number} axis @param {number} place @param {number} dark @param {number} bright */
  picture(axis, place, dark, bright) {
    return this.copy('picture', axis, place, dark, bright);
  }

  leastMemory() {
    return this.call('min_memory');
  }
  /** The scan on a device. @param {number} memory in bytes; 0: as a stream of slices */
  scan(memory) {
    const [bytes, regions, fragments, used] = this.numbersAt(this.call('scan', memory), 4);
    return { bytes, regions, fragments, used };
  }
  /** The stream of the last scan. */
  stream() {
    return this.copy('stream');
  }

  /** @param {{scan: number, channel: number}} [choice] of several surfaces; else the first */
  newStream(choice) {
    this.call('new_stream', choice?.scan ?? -1, choice?.channel ?? -1);
  }
  /** @param {Uint8Array} bytes */
  pushStream(bytes) {
    const at = this.call('allocate', bytes.length);
    new Uint8Array(this.exports.memory.buffer, at >>> 0, bytes.length).set(bytes);
    this.call('push_stream', at, bytes.length);
    this.call('release', at);
  }
  endStream() {
    this.call('end_stream');
    return this.streamState();
  }
  /**
   * Its surface as a mesh: places in half-steps and normals, three numbers a vertex; the triangles in the order of
   * draw().
   * @param {boolean} isRelaxed or else it is interpolated
   */
  move(isRelaxed) {
    const leftOut = this.call('move', isRelaxed ? 1 : 0);
    return {
      leftOut, places: new Float32Array(this.copy('moved_places').buffer),
      normals: new Float32Array(this.copy('moved_normals').buffer),
      triangles: new Uint32Array(this.copy('moved_triangles').buffer),
    };
  }
  /**
   * What of it is missing: lines around that, six numbers of 16 bits each, in half-steps, and the first and last slices
   * of each part.
   * @param {boolean} isEnd whether no more comes
   */
  missing(isEnd) {
    this.call('find_missing', isEnd ? 1 : 0);
    const bounds = new Uint32Array(this.copy('missing_slices').buffer);
    const slices = [];
    for (let i = 0; i < bounds.length; i += 2) slices.push([bounds[i], bounds[i + 1]]);
    return { lines: this.copy('missing_lines'), slices };
  }
  /** What is known of it so far. */
  streamState() {
    const list = this.numbersAt(this.call('stream_state'), 19);
    const axes = this.numbersAt(this.call('stream_axes'), 10);
    const vectors = [0, 3, 6].map((begin) => axes.slice(begin, begin + 3));
    return {
      upright: placeOf([], vectors, axes[9] !== 0).upright,
      hasHeader: list[0] !== 0,
      dims: /** @type {[number, number, number]} */ (list.slice(1, 4)),
      spacing: /** @type {[number, number, number]} */ (list.slice(4, 7)),
      threshold: list[7], polygons: list[8], isComplete: list[9] !== 0, hasTrailer: list[10] !== 0,
      lostPackets: list[11], damagedPackets: list[12], lostPieces: list[13],
      holdsSlices: list[14] !== 0, classicTriangles: list[15], bytes: list[16],
      isClosed: list[17] !== 0, levels: list[18],
    };
  }
  /** All that share the link. @returns {{scan: number, channel: number, threshold: number}[]} */
  streamSurfaces() {
    const list = new Int32Array(this.copy('stream_surfaces').buffer);
    return Array.from({ length: list.length / 3 }, (_, i) =>
      ({ scan: list[3 * i], channel: list[3 * i + 1], threshold: list[3 * i + 2] }));
  }

  /** @param {string} name of a call that returns bytes @param {...number} values */
  copy(name, ...values) {
    const at = this.call(name, ...values) >>> 0;
    const view = new DataView(this.exports.memory.buffer);
    const data = view.getUint32(at, true);
    return new Uint8Array(view.buffer, data, view.getUint32(at + 4, true)).slice();
  }

  /** @param {number} at @param {number} count */
  numbersAt(at, count) {
    return [...new Float64Array(this.exports.memory.buffer, at >>> 0, count)];
  }

  /** @param {number} at */
  textAt(at) {
    const bytes = new Uint8Array(this.exports.memory.buffer, at >>> 0);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }
}
