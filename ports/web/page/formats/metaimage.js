// MetaImage: lines of a header, then the samples (.mha), or the name of the file that has them
// (.mhd).
import { placeOf } from './axes.js';
import { asText, inflated } from './bytes.js';
import { FileError } from './volume_info.js';

/** @type {Record<string, string>} */
const types = {
  MET_UCHAR: 'u8', MET_CHAR: 'i8', MET_USHORT: 'u16', MET_SHORT: 'i16', MET_UINT: 'u32',
  MET_INT: 'i32', MET_ULONG_LONG: 'u64', MET_LONG_LONG: 'i64', MET_FLOAT: 'f32', MET_DOUBLE: 'f64',
};

/** @param {Uint8Array} head */
export const isMetaImage = (head) =>
  /^\s*(ObjectType|NDims|Comment|ObjectSubType)\s*=/.test(asText(head.subarray(0, 64)));

/** @type {import('./volume_file.js').Reader} */
export async function readMetaImage(name, source, others) {
  const text = asText(await source.peek(1 << 16));
  const last = /^ElementDataFile[ \t]*=[ \t]*(.*?)[ \t]*(\r?\n|$)/m.exec(text);
  if (!last)
    throw new FileError(name, 'the header has no ElementDataFile', 'add it as the last line');
  const fields = new Map(text.slice(0, last.index).split(/\r?\n/).flatMap((line) => {
    const match = /^\s*(\w+)\s*=\s*(.*?)\s*$/.exec(line);
    return match ? [[match[1], match[2]]] : [];
  }));
  const is = (/** @type {string} */ key) => /^(true|1|y)/i.test(fields.get(key) ?? '');
  const numbers = (/** @type {string[]} */ ...keys) => {
    const key = keys.find((each) => fields.has(each));
    return key ? fields.get(key).split(/\s+/).map(Number) : [];
  };
  const type = types[fields.get('ElementType') ?? ''];
  if (!type)
    throw new FileError(name, `samples of ElementType ${fields.get('ElementType') ?? 'unknown'} are not supported`,
      'convert them to MET_SHORT');
  if ((fields.get('ElementNumberOfChannels') ?? '1') !== '1')
    throw new FileError(name, `the file holds ${fields.get('ElementNumberOfChannels')} channels`,
      'give a volume of one channel');
  if (fields.has('BinaryData') && !is('BinaryData'))
    throw new FileError(name, 'its samples are text', 'save it with BinaryData = True');
  const dims = numbers('DimSize');
  if (dims.slice(3).some((size) => size !== 1))
    throw new FileError(name, `the data has ${dims.length} dimensions`, 'give a volume of three');
  const slope = numbers('ElementToIntensityFunctionSlope')[0] ?? 1;
  const isScaled = slope > 0 && Number.isFinite(slope);
  const info = {
    format: 'MetaImage',
    dims: [dims[0] ?? 1, dims[1] ?? 1, dims[2] ?? 1],
    type,
    bigEndian: is('ElementByteOrderMSB') || is('BinaryDataByteOrderMSB'),
    ...placeFrom(numbers('ElementSpacing', 'ElementSize'),
      numbers('TransformMatrix', 'Rotation', 'Orientation')),
    slope: isScaled ? slope : 1,
    intercept: isScaled ? numbers('ElementToIntensityFunctionOffset')[0] ?? 0 : 0,
    isInHounsfield: false,
  };
  let data = source;
  if (last[1].toUpperCase() === 'LOCAL') {
    await source.skip(last.index + last[0].length);
  } else if (/^list|%/i.test(last[1])) {
    throw new FileError(name, `its samples are in several files (${last[1]})`,
      'store them in one file, or make a stream with discmc extract -o FILE.dmc');
  } else {
    data = await others(last[1]);
  }
  const skipped = Number(fields.get('HeaderSize') ?? 0);
  if (skipped < 0)
    throw new FileError(name, `HeaderSize is ${skipped}`, 'give the number of bytes before the samples');
  await data.skip(skipped);
  return { info, data: is('CompressedData') ? inflated(data, 'deflate') : data };
}

/** @param {number[]} lengths @param {number[]} matrix */
function placeFrom(lengths, matrix) {
  if (matrix.length !== 9) return placeOf(lengths);
  return placeOf(lengths, [0, 1, 2].map((axis) =>
    matrix.slice(3 * axis, 3 * axis + 3).map((part) => part * (lengths[axis] ?? 1))));
}
