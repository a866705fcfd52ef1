// Light on planes, as ports/command/pictures/shading.cpp has it: a key light over the left shoulder,
// and a cool fill.
import { bone, green, orange, rgb, skyBlue } from './palette.js';
import { dot, unit } from './vectors.js';

const incidences = 27;
const key = unit([-0.6, 0.7, 0.5]);

/** The lattice normal of an incidence. @param {number} incidence */
const latticeNormal = (incidence) =>
  [incidence % 3, Math.floor(incidence / 3) % 3, Math.floor(incidence / 9)].map((part) => part - 1);

/** The normals of all incidences, in space. @param {number[]} spacing */
export const planesOf = (spacing) => Array.from({ length: incidences }, (_, incidence) =>
  unit(latticeNormal(incidence).map((part, i) => part / spacing[i])));

/** The colours of all incidences: one, or those of the kinds of planes. */
export const plainBases = new Array(incidences).fill(rgb(bone));
export const whiteBases = new Array(incidences).fill([1, 1, 1]);
export const kindBases = Array.from({ length: incidences }, (_, incidence) => {
  const normal = latticeNormal(incidence);
  return rgb([bone, skyBlue, orange, green][dot(normal, normal)]);
});

/**
 * What is seen of each incidence.
 * @param {number[][]} planes @param {number[][]} bases
 * @param {{x: number[], y: number[], z: number[]}} axes of the viewer @param {boolean} isInside
 */
export function litPlanes(planes, bases, { x, y, z }, isInside) {
  const tone = isInside ? [0.3, 0.6, 1.2] : [1, 1, 1];
  const sky = [0.7, 0.95, 1.4];
  return planes.map((plane, incidence) => {
    const seen = [x, y, z].map((axis) => (isInside ? -1 : 1) * dot(plane, axis));
    const fill = 0.14 + 0.08 * seen[1];
    const light = 0.28 * Math.max(0, seen[2]) + 0.74 * Math.max(0, dot(seen, key));
    return bases[incidence].map((base, i) =>
      base * (tone[i] * (fill * sky[i] + light)) ** (1 / 2.2));
  });
}
