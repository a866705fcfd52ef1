// Binary STL, in millimetres.
import { cross, unit } from '../vectors.js';

/** @param {{places: Float32Array, corners: Uint32Array}} mesh */
export function stl({ places, corners }) {
  const count = corners.length / 3;
  const file = new DataView(new ArrayBuffer(84 + 50 * count));
  new TextEncoder().encodeInto('discmc, millimetres', new Uint8Array(file.buffer));
  file.setUint32(80, count, true);
  for (let i = 0; i < count; ++i) {
    const [a, b, c] = [0, 1, 2].map((corner) => 3 * corners[3 * i + corner]);
    const at = (/** @type {number} */ place) => places.subarray(place, place + 3);
    [normalOf(at(a), at(b), at(c)), at(a), at(b), at(c)].forEach((vector, j) => {
      for (let axis = 0; axis < 3; ++axis)
        file.setFloat32(84 + 50 * i + 12 * j + 4 * axis, vector[axis], true);
    });
  }
  return new Blob([file.buffer], { type: 'model/stl' });
}

/** @param {Float32Array} a @param {Float32Array} b @param {Float32Array} c */
function normalOf(a, b, c) {
  const [u, v] = [b, c].map((end) => end.map((at, i) => at - a[i]));
  return unit(cross(u, v));
}
