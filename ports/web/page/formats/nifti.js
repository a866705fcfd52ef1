// NIfTI-1 and NIfTI-2: one file (.nii), or a header with the samples beside it (.hdr, .img).
import { placeOf } from './axes.js';
import { asText } from './bytes.js';
import { FileError } from './volume_info.js';

/** @type {Map<number, string>} */
const types = new Map([
  [2, 'u8'], [256, 'i8'], [512, 'u16'], [4, 'i16'], [768, 'u32'], [8, 'i32'], [1280, 'u64'],
  [1024, 'i64'], [16, 'f32'], [64, 'f64'],
]);

const sizes = { 1: 348, 2: 540 };

/** @param {Uint8Array} head @returns {{version: 1 | 2, isLittle: boolean} | null} */
function kindOf(head) {
  if (head.length < sizes[1]) return null;
  const view = new DataView(head.buffer, head.byteOffset, head.length);
  for (const isLittle of [true, false]) {
    const size = view.getInt32(0, isLittle);
    if (size === sizes[1] && /^n[i+]1/.test(asText(head.subarray(344, 348))))
      return { version: 1, isLittle };
    if (size === sizes[2] && /^n[i+]2/.test(asText(head.subarray(4, 8))))
      return { version: 2, isLittle };
  }
  return null;
}

/** @param {Uint8Array} head */
export const isNifti = (head) => kindOf(head) !== null;

/** @type {import('./volume_file.js').Reader} */
export async function readNifti(name, source, others) {
  const head = await source.peek(sizes[2]);
  const kind = kindOf(head);
  if (!kind || head.length < sizes[kind.version])
    throw new FileError(name, 'the header is cut off', 'check whether the file is complete');
  const header = fieldsOf(new DataView(head.buffer, head.byteOffset, head.length), kind);
  const type = types.get(header.datatype);
  if (!type)
    throw new FileError(name, `samples of datatype ${header.datatype} are not supported`,
      'convert them to int16');
  const further = header.dim.slice(4, 1 + header.dim[0]);
  if (further.some((size) => size > 1))
    throw new FileError(name, `the file holds ${further.reduce((a, b) => a * b, 1)} volumes`,
      'save one of them as a file of its own');
  const dimensions = header.dim[0];
  if (dimensions < 1 || dimensions > 7)
    throw new FileError(name, `the header declares ${dimensions} dimensions`, 'correct dim[0]');
  if (!(header.offset >= 0 && Number.isFinite(header.offset)))
    throw new FileError(name, `vox_offset is ${header.offset}`, 'correct the header');
  const isScaled = header.slope !== 0 && Number.isFinite(header.slope) && header.slope > 0;
  const info = {
    format: `NIfTI-${kind.version}`,
    dims: [1, 2, 3].map((axis) => (axis <= header.dim[0] ? header.dim[axis] : 1)),
    type,
    bigEndian: !kind.isLittle,
    ...placeFrom(header),
    slope: isScaled ? header.slope : 1,
    intercept: isScaled && Number.isFinite(header.intercept) ? header.intercept : 0,
    isInHounsfield: false,
  };
  const isPair = asText(head.subarray(kind.version === 1 ? 344 : 4)).startsWith('ni');
  const data = isPair ? await others(name.replace(/\.hdr(\.gz)?$/i, '.img$1')) : source;
  await data.skip(isPair ? header.offset : Math.max(header.offset, sizes[kind.version] + 4));
  return { info, data };
}

/** @param {DataView} view @param {{version: 1 | 2, isLittle: boolean}} kind */
function fieldsOf(view, { version, isLittle }) {
  const short = (/** @type {number} */ at) => view.getInt16(at, isLittle);
  const float = (/** @type {number} */ at) => view.getFloat32(at, isLittle);
  const double = (/** @type {number} */ at) => view.getFloat64(at, isLittle);
  const long = (/** @type {number} */ at) => Number(view.getBigInt64(at, isLittle));
  const list = (/** @type {number} */ count, /** @type {(at: number) => number} */ read,
    /** @type {number} */ at, /** @type {number} */ step) =>
    Array.from({ length: count }, (_, i) => read(at + i * step));
  if (version === 1)
    return {
      dim: list(8, short, 40, 2), datatype: short(70), pixdim: list(8, float, 76, 4),
      offset: float(108), slope: float(112), intercept: float(116), units: view.getUint8(123),
      qform: short(252), sform: short(254), quatern: list(3, float, 256, 4),
      rows: [280, 296, 312].map((at) => list(3, float, at, 4)),
    };
  return {
    dim: list(8, long, 16, 8), datatype: short(12), pixdim: list(8, double, 104, 8),
    offset: long(168), slope: double(176), intercept: double(184),
    units: view.getInt32(500, isLittle), qform: view.getInt32(344, isLittle),
    sform: view.getInt32(348, isLittle), quatern: list(3, double, 352, 8),
    rows: [400, 432, 464].map((at) => list(3, double, at, 8)),
  };
}

/** @param {ReturnType<typeof fieldsOf>} header */
function placeFrom(header) {
  const unit = { 1: 1000, 3: 1e-3 }[header.units & 7] ?? 1;
  const lengths = header.pixdim.slice(1, 4).map((length) => unit * Math.abs(length));
  if (header.sform > 0) {
    const axes = [0, 1, 2].map((axis) => header.rows.map((row) => unit * row[axis]));
    const steps = axes.map((axis) => Math.hypot(...axis));
    const isUsable = steps.every((length) => length >= 1e-6 && length <= 1e6);
    const place = placeOf(isUsable ? steps : lengths, isUsable ? axes : undefined, true);
    const ofItsOwn = 5; // "template, other": what its directions are is not known
    return header.sform === ofItsOwn ? { spacing: place.spacing } : place;
  }
  return placeOf(lengths, header.qform > 0 ? rotation(header) : undefined, true);
}

// The axes by the quaternion (nifti1.h, method 2).
/** @param {ReturnType<typeof fieldsOf>} header */
function rotation({ quatern: [b, c, d], pixdim }) {
  const a = Math.sqrt(Math.max(0, 1 - b * b - c * c - d * d));
  const side = pixdim[0] < 0 ? -1 : 1;
  return [
    [a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)],
    [2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)],
    [2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c].map((x) => side * x),
  ];
}
