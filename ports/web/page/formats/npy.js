// NumPy arrays: array[z][y][x], or in Fortran order array[x][y][z]. They have no spacing.
import { asText } from './bytes.js';
import { FileError } from './volume_info.js';

/** @param {Uint8Array} head */
export const isNpy = (head) => head[0] === 0x93 && asText(head.subarray(1, 6)) === 'NUMPY';

/** @type {import('./volume_file.js').Reader} */
export async function readNpy(name, source) {
  const start = await source.peek(12);
  if (start.length < 12)
    throw new FileError(name, 'the header is cut off', 'save the array again');
  const view = new DataView(start.buffer, start.byteOffset, start.length);
  const begin = start[6] === 1 ? 10 : 12;
  const length = start[6] === 1 ? view.getUint16(8, true) : view.getUint32(8, true);
  if (length > 1 << 16)
    throw new FileError(name, `the header has ${length} bytes`, 'check whether the file is damaged');
  const text = asText((await source.peek(begin + length)).subarray(begin));
  const descr = /'descr':\s*'([<>|=])(u[1248]|i[1248]|f[48])'/.exec(text);
  const shape = /'shape':\s*\(([\d, ]*)\)/.exec(text);
  if (!descr || !shape)
    throw new FileError(name, 'the array is not of numbers', 'save an array of int16 or float32');
  const sizes = shape[1].split(',').filter((size) => size.trim()).map(Number);
  const isFortran = /'fortran_order':\s*True/.test(text);
  const dims = (isFortran ? sizes : sizes.reverse()).concat(1, 1).slice(0, Math.max(3, sizes.length));
  if (dims.length > 3)
    throw new FileError(name, `the array has ${dims.length} dimensions`, 'save an array of three');
  await source.skip(begin + length);
  const info = {
    format: 'NumPy',
    dims,
    type: `${descr[2][0]}${8 * Number(descr[2][1])}`,
    bigEndian: descr[1] === '>',
    spacing: [1, 1, 1],
    slope: 1,
    intercept: 0,
    isInHounsfield: false,
  };
  return { info, data: source };
}
