// Binary glTF 2.0: metres, y upwards, shaded flat.
import { bone, rgb } from '../palette.js';

const json = 0x4e4f534a, binary = 0x004e4942; // kinds of chunks

/** @param {{places: Float32Array, corners: Uint32Array}} mesh */
export function glb({ places, corners }) {
  const bounds = boundsOf(places);
  const description = JSON.stringify({
    asset: { version: '2.0', generator: 'discmc' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    // From millimetres with z upwards.
    nodes: [{ mesh: 0, matrix: [1e-3, 0, 0, 0, 0, 0, -1e-3, 0, 0, 1e-3, 0, 0, 0, 0, 0, 1] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, material: 0 }] }],
    materials: [{
      doubleSided: true,
      pbrMetallicRoughness: {
        baseColorFactor: [...rgb(bone).map((part) => part ** 2.2), 1],
        metallicFactor: 0,
        roughnessFactor: 0.7,
      },
    }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: places.length / 3, type: 'VEC3', ...bounds },
      { bufferView: 1, componentType: 5125, count: corners.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: places.byteLength, target: 34962 },
      { buffer: 0, byteOffset: places.byteLength, byteLength: corners.byteLength, target: 34963 },
    ],
    buffers: [{ byteLength: places.byteLength + corners.byteLength }],
  });
  const text = new TextEncoder().encode(description + ' '.repeat(-description.length & 3));
  const bytes = places.byteLength + corners.byteLength;
  const head = new Uint32Array([0x46546c67, 2, 28 + text.length + bytes, text.length, json]);
  return new Blob([head, text, new Uint32Array([bytes, binary]), places, corners],
    { type: 'model/gltf-binary' });
}

/** @param {Float32Array} places */
function boundsOf(places) {
  const min = [Infinity, Infinity, Infinity], max = [-Infinity, -Infinity, -Infinity];
  places.forEach((at, i) => {
    min[i % 3] = Math.min(min[i % 3], at);
    max[i % 3] = Math.max(max[i % 3], at);
  });
  return { min, max };
}
