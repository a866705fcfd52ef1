// Vectors of three parts.

/** In the direction of v, 1 long; 0 where v is. @param {number[]} v */
export const unit = (v) => {
  const length = Math.hypot(...v) || 1;
  return v.map((part) => part / length);
};

/** @param {number[]} a @param {number[]} b */
export const dot = (a, b) => a.reduce((sum, part, i) => sum + part * b[i], 0);

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
