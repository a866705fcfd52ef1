// The worker: everything that takes time. One request after the other, each answered.
import { swapBytes } from './formats/bytes.js';
import { openFiles, UnknownLayout } from './formats/volume_file.js';
import { FileError, requireExtents, sampleBytes, sampleTypes, volumeBytes } from './formats/volume_info.js';
import { Module } from './module.js';
import { bone, rgb } from './palette.js';
import { bestShape } from './shape.js';

/** @type {BufferSource} */
let moduleBytes;
/** @type {Module} */
let module;
let count = 0; // of what was opened, one after the other

const opening = ['start', 'open', 'listen'];
const ofVolumes = ['surface', 'classic', 'picture', 'scan', 'stream'];

const requests = {
  /** @param {{bytes: BufferSource}} request */
  async start({ bytes }) {
    moduleBytes = bytes;
    module = await Module.start(bytes);
  },

  /**
   * Opens a volume, a mesh or a stream in place of what is open; if that fails, this stays.
   * @param {{files: File[], layout?: import('./formats/raw.js').RawLayout,
   *   choice?: {scan: number, channel: number}}} request choice: which surface of a stream
   */
  async open({ files, layout, choice }) {
    const { name, info, mesh, data } = await openFiles(files, layout);
    const opened = await Module.start(moduleBytes);
    const result = mesh ? { name, mesh } : await (info
      ? openVolume(opened, name, info, data) : openStream(opened, name, data, choice));
    module = opened;
    ++count;
    return result;
  },

  /** @param {{iso: number, isFiltered: boolean, hasEdges: boolean, isSmooth: boolean}} request */
  surface({ iso, isFiltered, hasEdges, isSmooth }) {
    const begin = performance.now();
    const counts = module.extract(iso, isFiltered);
    return { iso, counts, ...drawn(hasEdges, isSmooth), milliseconds: performance.now() - begin };
  },

  /** The surface of the stream. @param {Wishes} wishes */
  redraw(wishes) {
    return drawnStream(module.streamState(), wishes);
  },

  /** Begins a stream that arrives piece by piece. */
  async listen() {
    module = await Module.start(moduleBytes);
    module.newStream();
    ++count;
  },

  /** @param {{bytes: Uint8Array}} request */
  receive({ bytes }) {
    module.pushStream(bytes);
  },

  /** What has arrived so far. @param {{isEnd: boolean} & Wishes} request */
  arrived({ isEnd, ...wishes }) {
    const stream = isEnd ? module.endStream() : module.streamState();
    const surfaces = module.streamSurfaces();
    if (!stream.hasHeader) return { stream, surfaces, surface: null };
    return { stream, surfaces, surface: drawnStream(stream, wishes), missing: module.missing(isEnd) };
  },

  classic() {
    return module.classic();
  },

  /** @param {{axis: number, place: number, dark: number, bright: number}} request */
  picture({ axis, place, dark, bright }) {
    return module.picture(axis, place, dark, bright);
  },

  /** @param {{memory: number}} request */
  scan({ memory }) {
    const least = module.leastMemory();
    return { least, regions: module.scan(Math.max(memory, least)), slices: module.scan(0) };
  },

  /** @param {{memory: number}} request */
  stream({ memory }) {
    module.scan(memory);
    return module.stream();
  },

  polygons() {
    return module.polygons();
  },
};

/**
 * @param {Module} opened
 * @param {string} name @param {import('./formats/volume_info.js').VolumeInfo} info
 * @param {import('./formats/bytes.js').ByteSource} data
 */
async function openVolume(opened, name, info, data) {
  const bytes = volumeBytes(info);
  const samples = opened.newVolume(info, sampleTypes.indexOf(info.type), bytes);
  const filled = await data.fill(samples);
  data.cancel();
  if (filled < bytes)
    throw new FileError(name,
      `the file ends after ${filled} of ${bytes} bytes of samples (${info.dims.join(' x ')} ${info.type})`,
      'check whether the file is complete');
  if (info.bigEndian) swapBytes(samples, sampleBytes(info.type));
  const values = opened.measure();
  if (values.count === 0)
    throw new FileError(name, 'no value is finite', 'check the file');
  return { name, info, values };
}

/**
 * @param {Module} opened @param {string} name @param {import('./formats/bytes.js').ByteSource} data
 * @param {{scan: number, channel: number}} [choice]
 */
async function openStream(opened, name, data, choice) {
  opened.newStream(choice);
  for (let piece = await data.next(); piece; piece = await data.next()) opened.pushStream(piece);
  const stream = opened.endStream();
  if (!stream.hasHeader)
    throw new FileError(name, `there is no header of a discmc stream in its ${stream.bytes} bytes`,
      'check that this is a stream (.dmc)');
  requireExtents(name, stream.dims);
  return { name, stream, surfaces: opened.streamSurfaces(), missing: opened.missing(true) };
}

/**
 * Whether a request is about what is open no more.
 * @param {string} call @param {number} opened what was open as it was made
 */
function isStale(call, opened) {
  return !opening.includes(call) &&
    (opened !== count || (ofVolumes.includes(call) && !module.hasVolume));
}

/** @param {boolean} hasEdges @param {boolean} isSmooth */
function drawn(hasEdges, isSmooth) {
  const surface = module.draw();
  return {
    ...surface,
    edges: hasEdges ? module.edges() : null,
    normals: isSmooth ? module.normals() : null,
  };
}

/** @typedef {{hasEdges: boolean, shape: import('./shape.js').Shape | null}} Wishes shape: null for the best */

/** @param {{levels: number}} stream @param {Wishes} wishes */
function drawnStream({ levels }, { hasEdges, shape }) {
  const best = bestShape(levels);
  const drawnShape = shape === 'interpolated' ? best : (shape ?? best);
  if (drawnShape === 'polygons') return drawn(hasEdges, false);
  const mesh = module.move(drawnShape === 'relaxed');
  const colour = rgb(bone).map((part) => Math.round(255 * part));
  const colours = new Uint8Array((4 * mesh.places.length) / 3).fill(255);
  for (let i = 0; i < colours.length; i += 4) colours.set(colour, i);
  return { ...mesh, colours, shape: drawnShape };
}

/** What can be handed over instead of copied. @param {any} result @returns {Transferable[]} */
function transferables(result) {
  if (ArrayBuffer.isView(result)) return [result.buffer];
  return result && typeof result === 'object' ? Object.values(result).flatMap(transferables) : [];
}

/** @param {unknown} error @param {string} file */
function asAnswer(error, file) {
  if (error instanceof UnknownLayout)
    return { unknownLayout: { name: error.file.name, size: error.file.size } };
  if (error instanceof FileError) return { message: error.message };
  if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError)
    return { message: `${file}: the file needs more memory than the page has; close other pages, ` +
      'or shrink the volume with discmc extract --shrink 2 -o FILE.dmc' };
  return { message: `${file}: ${error instanceof Error ? error.message : error}; ` +
    'check whether the file is damaged' };
}

let openName = 'discmc';
let turn = Promise.resolve();
self.onmessage = ({ data: { id, call, opened, ...request } }) => {
  turn = turn.then(async () => {
    if (call === 'open') openName = request.files[0].name;
    try {
      if (isStale(call, opened)) return self.postMessage({ id, opened: count, error: { isStale: true } });
      const result = await /** @type {any} */ (requests)[call](request);
      self.postMessage({ id, opened: count, result }, { transfer: transferables(result) });
    } catch (error) {
      self.postMessage({ id, opened: count, error: asAnswer(error, openName) });
    }
  });
};
