// DICOM: the images of a series, a file each or frames of one, put in order along their normal.
import dicomParser from 'dicom-parser';
import { cross, dot } from '../vectors.js';
import { placeOf } from './axes.js';
import { asText, ByteSource, swapBytes } from './bytes.js';
import { partsOf, unpackFor } from './dicom_frames.js';
import { FileError, sampleBytes } from './volume_info.js';

const implicitLittle = '1.2.840.10008.1.2', big = '1.2.840.10008.1.2.2';
const remedy = 'use discmc view FOLDER, or make a stream with discmc extract FOLDER -o FILE.dmc';

/** @param {Uint8Array} head */
export const isDicom = (head) => asText(head.subarray(128, 132)) === 'DICM';

/**
 * @typedef {object} Image
 * @property {File} file
 * @property {string} series @property {string} description @property {string} modality
 * @property {number} columns @property {number} rows
 * @property {import('./volume_info.js').SampleType} type
 * @property {boolean} bigEndian @property {number} highBit @property {number} bits
 * @property {number} slope @property {number} intercept
 * @property {number[]} spacing from column to column, from row to row, and of slices if stored
 * @property {number[]} position @property {number[]} alongRow @property {number[]} alongColumn
 * @property {import('./dicom_frames.js').Part[]} parts of the file, which have the pixels
 * @property {import('./dicom_frames.js').Unpack} unpack
 */

/**
 * If there are several series, it reads the one with the most images.
 * @param {File[]} files
 * @returns {Promise<{name: string, info: any, data: ByteSource}>}
 */
export async function readDicom(files) {
  const images = [];
  for (const file of files) images.push(...(await imagesOf(file))); // one file in memory at a time
  if (images.length === 0)
    throw new FileError(files[0].name, 'there is no image of a volume', 'give the folder of a series');
  /** @type {Map<string, Image[]>} */
  const stacks = new Map();
  for (const image of images) {
    const key = [image.series, image.columns, image.rows, image.type, image.bigEndian,
      ...[...image.alongRow, ...image.alongColumn].map((part) => part.toFixed(3))].join();
    stacks.set(key, [...(stacks.get(key) ?? []), image]);
  }
  const [stack] = [...stacks.values()].sort((a, b) => b.length - a.length);
  const { ordered, distance, axes } = inOrder(stack);
  const [first] = ordered;
  const hasOneScale = ordered.every(({ slope, intercept }) =>
    slope === first.slope && intercept === first.intercept);
  const info = {
    format: 'DICOM',
    dims: [first.columns, first.rows, ordered.length],
    type: hasOneScale ? first.type : 'f32',
    bigEndian: false, // swapped where the bits are cut
    ...placeOf([first.spacing[0], first.spacing[1], distance], axes),
    slope: hasOneScale ? first.slope : 1,
    intercept: hasOneScale ? first.intercept : 0,
    isInHounsfield: first.modality === 'CT' && first.intercept < 0,
  };
  const series = first.description || first.modality || 'DICOM';
  return {
    name: stacks.size > 1 ? `${series} (the largest of ${stacks.size} stacks)` : series,
    info,
    data: samplesOf(ordered, hasOneScale),
  };
}

/** One for each frame. @param {File} file @returns {Promise<Image[]>} none where it has no pixels */
async function imagesOf(file) {
  if (!isDicom(new Uint8Array(await file.slice(0, 132).arrayBuffer()))) return [];
  const bytes = new Uint8Array(await file.arrayBuffer());
  const syntax = metaOf(file, bytes).string('x00020010') ?? implicitLittle;
  const unpack = unpackFor(syntax);
  if (!unpack)
    throw new FileError(file.name,
      `its compression is not supported by the page (transfer syntax ${syntax})`, remedy);
  const data = parsed(file, bytes);
  const pixels = data.elements.x7fe00010;
  if (!pixels) return [];
  const columns = data.uint16('x00280011'), rows = data.uint16('x00280010');
  const allocated = data.uint16('x00280100');
  if ((data.uint16('x00280002') ?? 1) !== 1 || ![8, 16, 32].includes(allocated))
    throw new FileError(file.name, 'the image is in colour, or its samples are not supported by the page', remedy);
  const frameBytes = columns * rows * (allocated / 8);
  const frames = numbersIn(data, 'x00280008')[0] ?? 1;
  const parts = partsOf(pixels, frames, frameBytes);
  if (!parts)
    throw new FileError(file.name, 'frames are missing', 'copy or export it again');
  const bits = data.uint16('x00280101') ?? allocated;
  const common = {
    file, columns, rows, bits, unpack,
    type: /** @type {any} */ (`${data.uint16('x00280103') === 1 ? 'i' : 'u'}${allocated}`),
    bigEndian: syntax === big,
    highBit: data.uint16('x00280102') ?? bits - 1,
    series: data.string('x0020000e') ?? '',
    description: data.string('x0008103e') ?? '',
    modality: data.string('x00080060') ?? '',
  };
  return Array.from({ length: frames }, (_, frame) => {
    // An element of the frame, of all frames together, or of the file as a whole.
    const [own, shared] = [data.elements.x52009230?.items?.[frame], data.elements.x52009229?.items?.[0]];
    const read = (/** @type {string} */ group, /** @type {string} */ tag) => {
      const holders = [own, shared].map((item) => item?.dataSet.elements[group]?.items?.[0]?.dataSet);
      const holder = holders.find((each) => each?.elements[tag]) ?? data;
      return numbersIn(holder, tag);
    };
    const direction = read('x00209116', 'x00200037');
    const [down, right] = read('x00289110', 'x00280030');
    return {
      ...common,
      parts: parts[frame],
      slope: read('x00289145', 'x00281053')[0] ?? 1,
      intercept: read('x00289145', 'x00281052')[0] ?? 0,
      spacing: [right ?? 1, down ?? 1,
        read('x00289110', 'x00180088')[0] ?? read('x00289110', 'x00180050')[0] ?? 1],
      position: read('x00209113', 'x00200032'),
      alongRow: direction.slice(0, 3),
      alongColumn: direction.slice(3, 6),
    };
  });
}

/** @param {any} data @param {string} tag @returns {number[]} */
const numbersIn = (data, tag) => (data.string(tag) ?? '').split('\\').filter(Boolean).map(Number);

/** @param {File} file @param {Uint8Array} bytes */
const metaOf = (file, bytes) => parsed(file, bytes, { untilTag: 'x0002ffff' });

/** @param {File} file @param {Uint8Array} bytes @param {object} [options] */
function parsed(file, bytes, options) {
  try {
    return dicomParser.parseDicom(bytes, options);
  } catch (error) {
    // The library throws texts, and objects with an `exception`.
    const { exception } = /** @type {any} */ (error);
    throw new FileError(file.name, `the file is damaged (${exception ?? error})`, 'copy or export it again');
  }
}

/** Along the normal, each position once. @param {Image[]} stack */
function inOrder(stack) {
  const [first] = stack;
  const { alongRow: u, alongColumn: v } = first;
  const hasPlaces = stack.every(({ position }) => position.length === 3) && u.length + v.length === 6;
  if (!hasPlaces && stack.some(({ file }) => file !== first.file))
    throw new FileError(first.file.name, 'the slices have no position, so their order is unknown',
      'export the series with positions');
  if (!hasPlaces) return { ordered: stack, distance: first.spacing[2], axes: undefined };
  const normal = cross(u, v);
  const height = (/** @type {Image} */ { position }) => dot(position, normal);
  const sorted = [...stack].sort((a, b) => height(a) - height(b));
  const ordered = sorted.filter((image, i) => i === 0 || height(image) - height(sorted[i - 1]) > 1e-3);
  const distance = ordered.length === 1 ? first.spacing[2]
    : (height(ordered[ordered.length - 1]) - height(ordered[0])) / (ordered.length - 1);
  ordered.forEach((image, i) => {
    const step = i === 0 ? distance : height(image) - height(ordered[i - 1]);
    if (Math.abs(step - distance) > 0.05 * distance)
      throw new FileError(image.file.name,
        `the previous slice is ${step.toFixed(2)} mm away, and others ${distance.toFixed(2)} mm`,
        'give the whole series, or fill the gaps with discmc extract --allow-gaps');
  });
  return { ordered, distance, axes: [u, v, normal] };
}

/** Slice after slice, its bits and its sign alone. @param {Image[]} images @param {boolean} hasOneScale */
function samplesOf(images, hasOneScale) {
  const waiting = [...images];
  return new ByteSource(new ReadableStream({
    async pull(controller) {
      const image = waiting.shift();
      if (!image) return controller.close();
      const bytes = await pixelsOf(image);
      if (image.bigEndian) swapBytes(bytes, sampleBytes(image.type));
      const samples = cutToBits(bytes, image);
      if (hasOneScale) return controller.enqueue(new Uint8Array(samples.buffer));
      const values = Float32Array.from(samples, (stored) => image.slope * stored + image.intercept);
      controller.enqueue(new Uint8Array(values.buffer));
    },
  }));
}

/** @param {Image} image */
async function pixelsOf({ file, parts, unpack, columns, rows, type }) {
  const packed = new Blob(parts.map(({ begin, end }) => file.slice(begin, end)));
  const samples = columns * rows;
  try {
    const bytes = unpack(new Uint8Array(await packed.arrayBuffer()), samples, sampleBytes(type));
    if (bytes.length === samples * sampleBytes(type)) return bytes;
  } catch {
    // the message of a decoder is for its authors
  }
  throw new FileError(file.name, `its compressed pixels are not ${columns} x ${rows} of ${type}`,
    'copy or export it again');
}

const arrays = {
  u8: Uint8Array, i8: Int8Array, u16: Uint16Array, i16: Int16Array, u32: Uint32Array, i32: Int32Array,
};

/** @param {Uint8Array} bytes @param {Image} image */
function cutToBits(bytes, { type, bits, highBit }) {
  const samples = new (/** @type {any} */ (arrays)[type])(bytes.buffer);
  const width = 8 * sampleBytes(type);
  const isSigned = type.startsWith('i');
  if (bits === width) return samples;
  for (let i = 0; i < samples.length; ++i) {
    const high = samples[i] << (31 - highBit);
    samples[i] = isSigned ? high >> (32 - bits) : high >>> (32 - bits);
  }
  return samples;
}
