// The description of a volume, whatever its format.

/**
 * @typedef {object} VolumeInfo
 * @property {string} format for people
 * @property {[number, number, number]} dims voxels along x, y and z
 * @property {SampleType} type how samples are stored
 * @property {boolean} bigEndian
 * @property {[number, number, number]} spacing millimetres from voxel to voxel; negative where the
 *   axis runs backwards
 * @property {number[][]} [upright] the directions of space, as the surface has them: see axes.js
 * @property {number} slope value = slope * stored + intercept
 * @property {number} intercept
 * @property {boolean} isInHounsfield whether the file states it
 */

/** @typedef {'u8'|'i8'|'u16'|'i16'|'u32'|'i32'|'u64'|'i64'|'f32'|'f64'} SampleType */

/** In the order in which the module numbers them. @type {SampleType[]} */
export const sampleTypes = ['u8', 'i8', 'u16', 'i16', 'u32', 'i32', 'u64', 'i64', 'f32', 'f64'];

/** @param {SampleType} type */
export const sampleBytes = (type) => Number(type.slice(1)) / 8;

/** @param {VolumeInfo} info */
export const volumeBytes = (info) =>
  info.dims[0] * info.dims[1] * info.dims[2] * sampleBytes(info.type);

/** An error that names the file, what is wrong with it, and what to do. */
export class FileError extends Error {
  /** @param {string} file @param {string} what @param {string} remedy */
  constructor(file, what, remedy) {
    super(`${file}: ${what}; ${remedy}`);
    this.name = 'FileError';
  }
}

/** The largest volume of the page: beyond, a browser's memory may not hold the surface. */
export const maxBytes = 2 ** 30;
export const maxExtent = 16383;

/**
 * Refuses what is too large before anything is allocated.
 * @param {string} file @param {VolumeInfo} info
 */
export function requireSize(file, info) {
  const sizes = info.dims.join(' x ');
  if (!info.dims.every((extent) => Number.isInteger(extent) && extent > 0))
    throw new FileError(file, `the header declares ${sizes} voxels`, 'correct the header');
  requireExtents(file, info.dims);
  if (volumeBytes(info) > maxBytes)
    throw new FileError(file,
      `${sizes} voxels are ${inMebibytes(volumeBytes(info))}; the page accepts at most ` +
        inMebibytes(maxBytes),
      'make a smaller stream with discmc extract --shrink 2 -o FILE.dmc, and open that');
}

/** @param {string} file @param {number[]} dims voxels */
export function requireExtents(file, dims) {
  if (Math.max(...dims) > maxExtent)
    throw new FileError(file,
      `${dims.join(' x ')} voxels; the page accepts at most ${maxExtent} along an axis`,
      'extract a part with discmc extract --crop -o FILE.dmc, and open that');
}

/** @param {number} bytes */
export const inMebibytes = (bytes) => `${Math.round(bytes / 2 ** 20).toLocaleString('en')} MiB`;
