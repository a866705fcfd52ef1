// What of a closed surface can face the viewer. The rest is not even asked for: half of the work.

/**
 * Parts of the triangles of a surface, which are in the order of their incidences.
 * @param {number[][]} planes the normals of all incidences
 * @param {Uint32Array} ends where the triangles of each incidence end
 * @param {number[]} eye from the middle of the space @param {number[]} halves of its extents
 * @returns {{begin: number, end: number}[]}
 */
export function facing(planes, ends, eye, halves) {
  /** @type {{begin: number, end: number}[]} */
  const parts = [];
  planes.forEach((plane, incidence) => {
    const [begin, end] = [incidence > 0 ? ends[incidence - 1] : 0, ends[incidence]];
    // The value of the eye over such a plane through the lowest corner of the space.
    const height = plane.reduce((sum, part, i) => sum + part * eye[i] + Math.abs(part) * halves[i], 0);
    if (begin === end || height <= 0) return;
    const last = parts[parts.length - 1];
    if (last?.end === begin) last.end = end;
    else parts.push({ begin, end });
  });
  return parts;
}
