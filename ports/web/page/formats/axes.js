// The axes of a volume in space: which run backwards, so that no shape is mirrored, and which way is up. The command
// decides alike.
import { cross, dot, unit } from '../vectors.js';

/**
 * @param {number[][]} axes the ways to the next voxel along x, y and z, in space
 * @returns {[number, number, number]} 1 or -1 each
 */
export function signsOf(axes) {
  const mostlyAlong = 0.75; // no other component can be larger
  const signs = [0, 1, 2].map((i) => (axes[i][i] < 0 ? -1 : 1));
  const isNear = axes.every((axis, i) => Math.abs(axis[i]) > mostlyAlong * Math.hypot(...axis));
  const hand = determinant(axes) < 0 ? -1 : 1;
  const isSame = signs[0] * signs[1] * signs[2] === hand;
  return /** @type {any} */ (isNear && isSame ? signs : [1, 1, hand]);
}

/** @param {number[][]} axes */
const determinant = ([x, y, z]) => dot(x, cross(y, z));

/**
 * Distances of voxels with the signs of the axes; what no spacing can be is 1 mm. And the directions
 * of space (left, posterior, superior where they are known) as the surface has them, whose axes are
 * those of the voxels.
 * @param {number[]} lengths @param {number[][]} [axes] of the voxels, in space
 * @param {boolean} [isRas] whether the directions of axes are right, anterior, superior
 * @returns {{spacing: [number, number, number], upright?: number[][]}}
 */
export function placeOf(lengths, axes, isRas = false) {
  const isUsable = (/** @type {number} */ length) => length >= 1e-6 && length <= 2147;
  const isGiven = axes && axes.flat().every(Number.isFinite) && determinant(axes) !== 0;
  const signs = isGiven ? signsOf(axes) : lengths.map((length) => (length < 0 ? -1 : 1));
  const spacing = /** @type {any} */ ([0, 1, 2].map((i) => {
    const length = Math.abs(lengths[i] ?? 1);
    return (signs[i] ?? 1) * (isUsable(length) ? length : 1);
  }));
  if (!isGiven) return { spacing };
  const inLps = isRas ? axes.map(([x, y, z]) => [-x, -y, z]) : axes;
  return { spacing, upright: uprightBy(inLps, signs) };
}

/** Makes oblique axes square. @param {number[][]} axes @param {number[]} signs */
function uprightBy(axes, signs) {
  const x = unit(axes[0].map((part) => signs[0] * part));
  const forwards = axes[1].map((part) => signs[1] * part);
  const y = unit(forwards.map((part, i) => part - dot(forwards, x) * x[i]));
  const z = cross(x, y);
  return [0, 1, 2].map((i) => [x[i], y[i], z[i]]);
}
