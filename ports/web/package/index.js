// Triangles of an array, and of the bytes of a device, for programs in JavaScript: index.d.ts.
import { Module } from '../page/module.js';
import { meshOf, movedMeshOf } from '../page/save/mesh.js';

const arrays = [Uint8Array, Int8Array, Uint16Array, Int16Array, Uint32Array, Int32Array,
  BigUint64Array, BigInt64Array, Float32Array, Float64Array];
const maxExtent = 16383;

async function bytesOfModule() {
  const address = new URL('./discmc.wasm', import.meta.url);
  if (address.protocol !== 'file:') {
    const answer = await fetch(address);
    if (!answer.ok) throw new Error(`${address}: status ${answer.status}; serve discmc.wasm beside index.js`);
    return answer.arrayBuffer();
  }
  const { readFile } = await import(/* webpackIgnore: true */ 'node:fs/promises');
  return readFile(address);
}

let compiled;
const compile = (source) =>
  (compiled ??= Promise.resolve(source ?? bytesOfModule()).then((bytes) => WebAssembly.compile(bytes)));

function typeOf(array) {
  const type = arrays.findIndex((each) => array instanceof each);
  if (type < 0)
    throw new TypeError('the samples are no typed array; give one such as new Float32Array(n)');
  return type;
}

function checkDims(array, dims) {
  for (const extent of dims)
    if (!Number.isInteger(extent) || extent < 1 || extent > maxExtent)
      throw new RangeError(`an extent is ${extent}; give whole numbers from 1 to ${maxExtent}`);
  const count = dims[0] * dims[1] * dims[2];
  if (dims.length !== 3 || array.length !== count)
    throw new RangeError(`the array has ${array.length} samples, and ${dims.join(' x ')} are ${count}`);
}

// The triangles of what a module holds.
function drawn(module, spacing) {
  const { vertices, triangles } = module.draw();
  const { places, corners } =
    meshOf(new Int16Array(vertices.buffer), new Uint32Array(triangles.buffer), spacing);
  return { positions: places, triangles: corners };
}

function extract(module, array, dims, iso, { spacing = [1, 1, 1], filter = false } = {}) {
  const type = typeOf(array);
  checkDims(array, dims);
  const info = { dims, spacing, slope: 1, intercept: 0, isInHounsfield: false };
  const samples = module.newVolume(info, type, array.byteLength);
  samples.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
  const { polygons } = module.extract(iso, filter);
  return { ...drawn(module, spacing), polygons };
}

function checkShape(surface, levels) {
  if (surface !== 'relaxed' && surface !== 'interpolated')
    throw new RangeError(`the surface is '${surface}'; give 'polygons', 'relaxed' or 'interpolated'`);
  if (surface === 'interpolated' && levels === 0)
    throw new RangeError("this stream holds no fractions to interpolate: give 'relaxed', or send them by " +
      'FractionSliceEncoder');
}

class Decoder {
  #module;
  constructor(module, choice) {
    this.#module = module;
    module.newStream(choice);
  }

  push(bytes) {
    this.#module.pushStream(bytes);
  }
  finish() {
    return this.#module.endStream();
  }
  get state() {
    return this.#module.streamState();
  }
  mesh({ surface = 'polygons' } = {}) {
    const { spacing, levels } = this.state;
    if (surface === 'polygons') return drawn(this.#module, spacing);
    checkShape(surface, levels);
    const { places, normals, triangles } = this.#module.move(surface === 'relaxed');
    const mesh = movedMeshOf(places, triangles, spacing);
    return { positions: mesh.places, triangles: mesh.corners, normals };
  }
}

export async function load({ wasm } = {}) {
  const compiledModule = await compile(wasm);
  const module = await Module.start(compiledModule);
  return {
    extract: (...values) => extract(module, ...values),
    decoder: async (choice) => new Decoder(await Module.start(compiledModule), choice),
  };
}
