// Headerless samples: the name of the file may contain the layout.
import { sampleBytes, sampleTypes } from './volume_info.js';

/**
 * @typedef {object} RawLayout
 * @property {[number, number, number]} dims
 * @property {import('./volume_info.js').SampleType} type
 * @property {boolean} bigEndian
 * @property {[number, number, number]} spacing
 */

/**
 * A layout to propose, by a name such as head_256x256x113_u16.raw and by the size.
 * @param {string} name @param {number} bytes @returns {RawLayout}
 */
export function proposedLayout(name, bytes) {
  const sizes = /(\d+)\s*[x×_]\s*(\d+)\s*[x×_]\s*(\d+)/i.exec(name);
  const named = sampleTypes.find((type) => new RegExp(`(^|[^a-z])${type.replace(/^u(\d+)/, 'u(?:int)?$1')
    .replace(/^i(\d+)/, 'i(?:nt)?$1').replace(/^f(\d+)/, 'f(?:loat)?$1')}([^0-9]|$)`, 'i').test(name));
  const edge = Math.max(1, Math.round(Math.cbrt(bytes)));
  /** @type {[number, number, number]} */
  const dims = sizes ? [Number(sizes[1]), Number(sizes[2]), Number(sizes[3])] : [edge, edge, edge];
  const voxels = dims[0] * dims[1] * dims[2];
  const fitting = sampleTypes.find((type) => sampleBytes(type) * voxels === bytes);
  return { dims, type: named ?? fitting ?? 'u8', bigEndian: false, spacing: [1, 1, 1] };
}

/** @param {RawLayout} layout */
export const rawInfo = (layout) => ({
  format: 'headerless', ...layout, slope: 1, intercept: 0, isInHounsfield: false,
});
