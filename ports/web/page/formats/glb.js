// Meshes: binary glTF 2.0 as discmc writes it, each mesh under a node with a matrix. In metres with y
// upwards; here millimetres with z upwards.
import { bone, rgb } from '../palette.js';
import { FileError, inMebibytes, maxBytes } from './volume_info.js';

const magic = 0x46546c67, jsonChunk = 0x4e4f534a, binaryChunk = 0x004e4942;
const arrays = { 5126: Float32Array, 5125: Uint32Array };
const steps = 256; // along the longest side of what surrounds all

/**
 * @typedef {object} DrawnMesh
 * @property {{name: string, colour: number[]}[]} parts red, green and blue from 0 to 1
 * @property {number[]} origin the lowest corner of all. Units: millimetres
 * @property {number[]} size of the box around all. Units: millimetres
 * @property {number} step the unit of what follows is half of it. Units: millimetres
 * @property {Float32Array} places three numbers a vertex, from the origin
 * @property {Float32Array | null} normals of any length
 * @property {Uint8Array} colours four numbers a vertex
 * @property {Uint32Array} triangles
 */

/** @param {Uint8Array} head */
export const isGlb = (head) => head.length >= 12 && viewOf(head).getUint32(0, true) === magic;

/** @param {Uint8Array} bytes */
const viewOf = (bytes) => new DataView(bytes.buffer, bytes.byteOffset, bytes.length);

/**
 * @param {string} name @param {import('./bytes.js').ByteSource} source
 * @returns {Promise<DrawnMesh>}
 */
export async function readGlb(name, source) {
  const foreign = (/** @type {string} */ what) =>
    new FileError(name, what, 'convert it with discmc view FILE.glb, and open that page');
  const bytes = await allOf(name, source);
  const chunks = chunksOf(bytes);
  if (!chunks) throw new FileError(name, 'the file is cut off or damaged', 'save it again');
  const gltf = JSON.parse(new TextDecoder().decode(chunks.json));
  const array = (/** @type {number} */ number, /** @type {string} */ shape) => {
    const { componentType, type, count, byteOffset = 0, bufferView, sparse } = gltf.accessors[number];
    const view = gltf.bufferViews[bufferView];
    const Type = /** @type {any} */ (arrays)[componentType];
    if (!Type || type !== shape || sparse || view.byteStride)
      throw foreign('the layout of its arrays is not that of discmc');
    const begin = chunks.binary + (view.byteOffset ?? 0) + byteOffset;
    const length = count * (shape === 'VEC3' ? 3 : 1);
    if (begin % 4 !== 0 || begin + 4 * length > bytes.length)
      throw new FileError(name, 'an array ends beyond the file', 'save it again');
    return new Type(bytes.buffer, begin, length);
  };
  const nodes = gltf.scenes?.[gltf.scene ?? 0]?.nodes ?? [];
  const parts = nodes.flatMap((/** @type {number} */ number) => {
    const { mesh, matrix, ...others } = gltf.nodes[number];
    if (mesh === undefined || !matrix || others.children)
      throw foreign('the layout of its nodes is not that of discmc');
    return gltf.meshes[mesh].primitives.map((/** @type {any} */ { attributes, indices, material, mode = 4 }) => {
      if (mode !== 4 || indices === undefined) throw foreign('its meshes are not indexed triangles');
      const places = array(attributes.POSITION, 'VEC3'), triangles = array(indices, 'SCALAR');
      if (triangles.some((/** @type {number} */ corner) => corner >= places.length / 3))
        throw new FileError(name, 'a triangle has no such vertex', 'save it again');
      return { name: gltf.meshes[mesh].name ?? '', colour: colourOf(gltf.materials?.[material]),
        toSpace: toSpace(matrix), places, triangles,
        normals: attributes.NORMAL === undefined ? null : array(attributes.NORMAL, 'VEC3') };
    });
  });
  if (parts.length === 0) throw new FileError(name, 'the file holds no mesh', 'open one with triangles');
  return joined(parts);
}

/** @param {string} name @param {import('./bytes.js').ByteSource} source */
async function allOf(name, source) {
  const pieces = [];
  let size = 0;
  for (let piece = await source.next(); piece; piece = await source.next()) {
    pieces.push(piece);
    size += piece.length;
    if (size > maxBytes)
      throw new FileError(name, `the page accepts at most ${inMebibytes(maxBytes)}`,
        'make a smaller mesh with discmc extract --triangles');
  }
  return new Uint8Array(await new Blob(pieces).arrayBuffer());
}

/** The text, and where the arrays begin; nothing of a damaged file. @param {Uint8Array} bytes */
function chunksOf(bytes) {
  const view = viewOf(bytes);
  if (bytes.length < 28 || view.getUint32(16, true) !== jsonChunk) return null;
  const end = 20 + view.getUint32(12, true);
  if (end + 8 > bytes.length || view.getUint32(end + 4, true) !== binaryChunk) return null;
  return { json: bytes.subarray(20, end), binary: end + 8 };
}

/** From metres with y upwards, after a matrix by columns. @param {number[]} m */
function toSpace(m) {
  const rows = [0, 2, 1].map((row, i) =>
    [0, 1, 2, 3].map((column) => (i === 1 ? -1000 : 1000) * m[4 * column + row]));
  return (/** @type {Float32Array} */ list, /** @type {number} */ at, /** @type {number} */ one) =>
    rows.map((row) => row[0] * list[at] + row[1] * list[at + 1] + row[2] * list[at + 2] + one * row[3]);
}

/** The format has linear light. @param {any} material */
function colourOf(material) {
  const factor = material?.pbrMetallicRoughness?.baseColorFactor;
  return factor ? factor.slice(0, 3).map((/** @type {number} */ part) =>
    (part <= 0.0031308 ? 12.92 * part : 1.055 * part ** (1 / 2.4) - 0.055)) : rgb(bone);
}

/** @param {any[]} parts @returns {DrawnMesh} */
function joined(parts) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const { places, toSpace } of parts)
    for (let i = 0; i < places.length; i += 3)
      toSpace(places, i, 1).forEach((/** @type {number} */ at, /** @type {number} */ axis) => {
        if (at < low[axis]) low[axis] = at;
        if (at > high[axis]) high[axis] = at;
      });
  const size = high.map((at, axis) => at - low[axis]);
  const step = Math.max(...size) / steps || 1;
  const sum = (/** @type {string} */ key) => parts.reduce((all, part) => all + part[key].length, 0);
  const places = new Float32Array(sum('places')), triangles = new Uint32Array(sum('triangles'));
  const colours = new Uint8Array((4 * places.length) / 3).fill(255);
  const normals = parts.every((part) => part.normals) ? new Float32Array(places.length) : null;
  let [vertex, corner] = [0, 0];
  for (const part of parts) {
    const colour = part.colour.map((/** @type {number} */ each) => Math.round(255 * each));
    for (let i = 0; i < part.places.length; i += 3) {
      const at = 3 * vertex + i;
      part.toSpace(part.places, i, 1).forEach((/** @type {number} */ place, /** @type {number} */ axis) => {
        places[at + axis] = ((place - low[axis]) * 2) / step;
      });
      if (normals) normals.set(part.toSpace(part.normals, i, 0), at);
      colours.set(colour, (4 * at) / 3);
    }
    part.triangles.forEach((/** @type {number} */ number, /** @type {number} */ i) => {
      triangles[corner + i] = vertex + number;
    });
    vertex += part.places.length / 3;
    corner += part.triangles.length;
  }
  return { parts: parts.map(({ name, colour }) => ({ name, colour })), origin: low, size, step, places,
    normals, colours, triangles };
}
