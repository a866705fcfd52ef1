// NRRD: a header of lines, then the samples, or the name of the file that has them.
import { placeOf } from './axes.js';
import { asText, unpacked } from './bytes.js';
import { FileError } from './volume_info.js';

const types = new Map(Object.entries({
  u8: ['uchar', 'unsigned char', 'uint8', 'uint8_t'],
  i8: ['signed char', 'int8', 'int8_t'],
  u16: ['ushort', 'unsigned short', 'unsigned short int', 'uint16', 'uint16_t'],
  i16: ['short', 'short int', 'signed short', 'signed short int', 'int16', 'int16_t'],
  u32: ['uint', 'unsigned int', 'uint32', 'uint32_t'],
  i32: ['int', 'signed int', 'int32', 'int32_t'],
  u64: ['ulonglong', 'unsigned long long', 'unsigned long long int', 'uint64', 'uint64_t'],
  i64: ['longlong', 'long long', 'long long int', 'signed long long', 'int64', 'int64_t'],
  f32: ['float'],
  f64: ['double'],
}).flatMap(([type, names]) => names.map((name) => [name, type])));

const longestHeader = 1 << 16;

/** @param {Uint8Array} head */
export const isNrrd = (head) => asText(head.subarray(0, 7)) === 'NRRD000';

/** @type {import('./volume_file.js').Reader} */
export async function readNrrd(name, source, others) {
  const text = asText(await source.peek(longestHeader));
  const end = /\r?\n\r?\n/.exec(text);
  const isDetached = /^data ?file:/im.test(end ? text.slice(0, end.index) : text);
  if (!end && !isDetached)
    throw new FileError(name, 'the header does not end', 'check whether the file is complete');
  const fields = fieldsOf(end ? text.slice(0, end.index) : text);
  const needed = (/** @type {string} */ key) => {
    const value = fields.get(key);
    if (value === undefined) throw new FileError(name, `the header has no ${key}`, 'add it');
    return value;
  };
  const type = types.get(needed('type').toLowerCase());
  if (!type)
    throw new FileError(name, `samples of type ${needed('type')} are not supported`,
      'convert them to short');
  const sizes = numbersOf(needed('sizes'));
  if (sizes.slice(3).some((size) => size !== 1))
    throw new FileError(name, `the data has ${sizes.length} dimensions (${sizes.join(' ')})`,
      'give a volume of three');
  const info = {
    format: 'NRRD',
    dims: [sizes[0] ?? 1, sizes[1] ?? 1, sizes[2] ?? 1],
    type,
    bigEndian: fields.get('endian')?.toLowerCase() === 'big',
    ...placeFrom(fields),
    slope: 1,
    intercept: 0,
    isInHounsfield: false,
  };
  let data = source;
  if (isDetached) {
    const file = needed('data file');
    if (/^list|%/i.test(file))
      throw new FileError(name, `its samples are in several files (${file})`,
        'store them in one file, or make a stream with discmc extract -o FILE.dmc');
    data = await others(file);
  } else {
    await source.skip((end?.index ?? 0) + (end?.[0].length ?? 0));
  }
  await skipLines(name, data, Number(fields.get('line skip') ?? 0));
  const encoding = needed('encoding').toLowerCase();
  if (encoding === 'gzip' || encoding === 'gz') data = await unpacked(data);
  else if (encoding !== 'raw')
    throw new FileError(name, `encoding ${encoding} is not supported`, 'save it with raw or gzip');
  const skipped = Number(fields.get('byte skip') ?? 0);
  if (skipped < 0)
    throw new FileError(name, `byte skip is ${skipped}`, 'give the number of bytes before the samples');
  await data.skip(skipped);
  return { info, data };
}

/** @param {string} text */
function fieldsOf(text) {
  const fields = new Map();
  for (const line of text.split(/\r?\n/)) {
    const match = /^([^#:]+):=?\s*(.*)$/.exec(line);
    if (match) fields.set(match[1].trim().toLowerCase().replace('datafile', 'data file')
      .replace(/^(line|byte)skip$/, '$1 skip'), match[2].trim());
  }
  return fields;
}

/** @param {string} text */
const numbersOf = (text) => text.trim().split(/[\s,]+/).map(Number);

/** @param {Map<string, string>} fields */
function placeFrom(fields) {
  const directions = fields.get('space directions');
  if (!directions) return placeOf(numbersOf(fields.get('spacings') ?? '1 1 1'));
  const axes = [...directions.matchAll(/\(([^)]*)\)/g)].map((vector) => numbersOf(vector[1]));
  if (axes.length < 3) return placeOf([1, 1, 1]);
  const isLeftHanded = /^(left-anterior-superior|last?)\b|3d-left-handed/i.test(fields.get('space') ?? '');
  if (isLeftHanded) for (const axis of axes) axis[0] = -axis[0]; // then it is RAS
  const isRas = isLeftHanded || /^(right-anterior-superior|rast?)\b/i.test(fields.get('space') ?? '');
  return placeOf(axes.map((axis) => Math.hypot(...axis)), axes, isRas);
}

/** @param {string} name @param {import('./bytes.js').ByteSource} data @param {number} lines */
async function skipLines(name, data, lines) {
  for (let skipped = 0; skipped < lines; ++skipped) {
    const end = (await data.peek(longestHeader)).indexOf(10);
    if (end < 0)
      throw new FileError(name, `line skip is ${lines}, but the file has ${skipped} lines`,
        'correct the line skip in the header');
    await data.skip(end + 1);
  }
}
