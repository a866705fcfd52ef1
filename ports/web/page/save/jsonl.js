// Polygons as lines of JSON, as the command writes them: normal and rings, in half-steps.

/** @param {Int32Array} numbers see Module.polygons() */
export function jsonl(numbers) {
  const parts = [];
  let lines = [];
  for (let at = 0; at < numbers.length; ) {
    const incidence = numbers[at++];
    const normal = [incidence % 3, Math.floor(incidence / 3) % 3, Math.floor(incidence / 9)];
    const rings = [];
    for (let left = numbers[at++]; left > 0; --left) {
      const corners = [];
      for (let count = numbers[at++]; count > 0; --count, at += 3)
        corners.push(`[${numbers[at]},${numbers[at + 1]},${numbers[at + 2]}]`);
      rings.push(`[${corners.join(',')}]`);
    }
    lines.push(`{"normal":[${normal.map((part) => part - 1)}],"rings":[${rings.join(',')}]}\n`);
    const most = 10000;
    if (lines.length === most) {
      parts.push(lines.join(''));
      lines = [];
    }
  }
  parts.push(lines.join(''));
  return new Blob(parts, { type: 'application/jsonl' });
}
