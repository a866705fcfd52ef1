// Where the surface meets a slice: between voxels that are on and others, at midpoints.

/**
 * Calls with the two ends of every piece. Units: voxels; voxel (0, 0) lies at (0, 0). Beyond the
 * picture all is off.
 * @param {Uint8Array} picture 128 and more where a voxel is on @param {number} width
 * @param {number} height
 * @param {(x1: number, y1: number, x2: number, y2: number) => void} piece
 */
export function outline(picture, width, height, piece) {
  const isOn = (/** @type {number} */ x, /** @type {number} */ y) =>
    x >= 0 && y >= 0 && x < width && y < height && picture[y * width + x] >= 128;
  for (let y = -1; y < height; ++y)
    for (let x = -1; x < width; ++x) {
      const a = isOn(x, y), b = isOn(x + 1, y), c = isOn(x, y + 1), d = isOn(x + 1, y + 1);
      if (a === b && c === d && a === c) continue;
      // Diagonal neighbours that are on are each cut off by themselves.
      const near = [x + 0.5, y], right = [x + 1, y + 0.5], far = [x + 0.5, y + 1], left = [x, y + 0.5];
      const join = (/** @type {number[]} */ from, /** @type {number[]} */ to) =>
        piece(from[0], from[1], to[0], to[1]);
      if (a === d && b === c) {
        join(near, a ? left : right);
        join(far, a ? right : left);
      } else {
        const ends = [a !== b && near, b !== d && right, c !== d && far, a !== c && left]
          .filter((end) => end !== false);
        join(ends[0], ends[1]);
      }
    }
}
