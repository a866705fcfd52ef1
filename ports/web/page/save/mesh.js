// The drawn triangles as a mesh in millimetres: each position once.

/**
 * @param {Int16Array} vertices four numbers each: x, y and z in half-steps, and the polygon's
 * @param {Uint32Array} triangles @param {number[]} spacing millimetres, signed
 */
export function meshOf(vertices, triangles, spacing) {
  /** @type {Map<number, number>} */
  const numbers = new Map();
  const places = [];
  const number = new Uint32Array(vertices.length / 4);
  for (let i = 0; i < number.length; ++i) {
    const [x, y, z] = vertices.subarray(4 * i, 4 * i + 3);
    const key = (x + 1) + 32768 * ((y + 1) + 32768 * (z + 1));
    let known = numbers.get(key);
    if (known === undefined) {
      known = numbers.size;
      numbers.set(key, known);
      places.push((x * spacing[0]) / 2, (y * spacing[1]) / 2, (z * spacing[2]) / 2);
    }
    number[i] = known;
  }
  return { places: new Float32Array(places), corners: outwards(triangles.map((i) => number[i]), spacing) };
}

/**
 * The same of a mesh whose vertices are moved.
 * @param {Float32Array} places three numbers a vertex, in half-steps
 * @param {Uint32Array} triangles @param {number[]} spacing millimetres, signed
 */
export function movedMeshOf(places, triangles, spacing) {
  return { places: places.map((at, i) => (at * spacing[i % 3]) / 2), corners: outwards(triangles, spacing) };
}

/** Counter-clockwise seen from outside also where an axis runs backwards. @param {Uint32Array} triangles @param {number[]} spacing */
function outwards(triangles, spacing) {
  if (spacing[0] * spacing[1] * spacing[2] > 0) return triangles;
  const corners = triangles.slice();
  for (let i = 0; i < corners.length; i += 3) [corners[i + 1], corners[i + 2]] = [corners[i + 2], corners[i + 1]];
  return corners;
}
