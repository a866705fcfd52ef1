// Finds where in a DICOM file the pixels of its frames are, and how they are unpacked.
import { Decoder } from 'jpeg-lossless-decoder-js';

/** @typedef {{begin: number, end: number}} Part of a file */
/** @typedef {(bytes: Uint8Array, samples: number, sampleBytes: number) => Uint8Array} Unpack */

/** How each transfer syntax packs frames. @type {Record<string, Unpack>} */
const unpacks = {
  '1.2.840.10008.1.2': plain,
  '1.2.840.10008.1.2.1': plain,
  '1.2.840.10008.1.2.2': plain,
  '1.2.840.10008.1.2.4.57': jpeg,
  '1.2.840.10008.1.2.4.70': jpeg,
  '1.2.840.10008.1.2.5': runLengths,
};

/** What makes samples of a frame, or undefined. @param {string} syntax */
export const unpackFor = (syntax) => unpacks[syntax];

/**
 * The parts of the file that each frame has.
 * @param {any} pixels the element, as dicom-parser has it @param {number} frames
 * @param {number} frameBytes where they are not packed
 * @returns {Part[][] | null} null if they cannot be separated, or some are missing
 */
export function partsOf(pixels, frames, frameBytes) {
  if (!pixels.encapsulatedPixelData) {
    if (pixels.length < frameBytes * frames) return null;
    return Array.from({ length: frames }, (_, frame) => {
      const begin = pixels.dataOffset + frame * frameBytes;
      return [{ begin, end: begin + frameBytes }];
    });
  }
  const { fragments, basicOffsetTable } = pixels;
  const firsts = firstsOf(fragments, basicOffsetTable, frames);
  if (firsts.length !== frames || firsts.some((first) => first < 0)) return null;
  return firsts.map((first, i) => fragments.slice(first, firsts[i + 1] ?? fragments.length)
    .map((/** @type {any} */ { position, length }) => ({ begin: position, end: position + length })));
}

/**
 * The first fragment of each frame: by the table, which may be empty, or one a frame, or all of one.
 * @param {any[]} fragments @param {number[]} table @param {number} frames
 */
function firstsOf(fragments, table, frames) {
  if (table.length > 0) return table.map((at) => fragments.findIndex(({ offset }) => offset === at));
  return frames === 1 && fragments.length > 0 ? [0] : fragments.map((_, i) => i);
}

/** @param {Uint8Array} bytes */
function plain(bytes) {
  return bytes;
}

/** @type {Unpack} */
function jpeg(bytes, _samples, sampleBytes) {
  const { buffer, byteOffset, length } = bytes;
  const decoded = new Decoder().decode(/** @type {ArrayBuffer} */ (buffer), byteOffset, length, sampleBytes);
  return new Uint8Array(decoded.buffer);
}

/**
 * A segment a byte of the samples, the most significant first; each is packed as PackBits has it.
 * @type {Unpack}
 */
function runLengths(bytes, samples, sampleBytes) {
  const header = new DataView(bytes.buffer, bytes.byteOffset, 64);
  const unpacked = new Uint8Array(samples * sampleBytes);
  for (let segment = 0; segment < sampleBytes; ++segment) {
    let from = header.getUint32(4 + 4 * segment, true), done = 0;
    const put = (/** @type {number} */ value) => {
      unpacked[sampleBytes * done++ + sampleBytes - 1 - segment] = value;
    };
    while (done < samples && from < bytes.length) {
      const code = bytes[from++];
      const count = code > 128 ? 257 - code : code + 1;
      if (code > 128) for (let i = 0; i < count; ++i) put(bytes[from]);
      else if (code < 128) for (let i = 0; i < count; ++i) put(bytes[from + i]);
      from += code > 128 ? 1 : code < 128 ? count : 0;
    }
    if (done < samples) throw new Error('the run lengths end early');
  }
  return unpacked;
}
