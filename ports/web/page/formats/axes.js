// Which axes of a volume run backwards, as the command decides it: so no shape is mirrored.

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

/** @param {number[][]} a */
function determinant(a) {
  return (
    a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
    a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
    a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0])
  );
}

/**
 * Distances of voxels with the signs of the axes. What no spacing can be is 1 mm.
 * @param {number[]} lengths @param {number[][]} [axes]
 * @returns {[number, number, number]}
 */
export function spacingOf(lengths, axes) {
  const isUsable = (/** @type {number} */ length) => length >= 1e-6 && length <= 2147;
  const isTold = axes && axes.flat().every(Number.isFinite) && determinant(axes) !== 0;
  const signs = isTold ? signsOf(axes) : lengths.map((length) => (length < 0 ? -1 : 1));
  return /** @type {any} */ ([0, 1, 2].map((i) => {
    const length = Math.abs(lengths[i] ?? 1);
    return (signs[i] ?? 1) * (isUsable(length) ? length : 1);
  }));
}
