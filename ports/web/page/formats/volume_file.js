// A dropped file, or several that belong together, as a volume, a mesh or a stream.
import { openBytes } from './bytes.js';
import { isDicom, readDicom } from './dicom.js';
import { isGlb, readGlb } from './glb.js';
import { isMetaImage, readMetaImage } from './metaimage.js';
import { isNifti, readNifti } from './nifti.js';
import { isNpy, readNpy } from './npy.js';
import { isNrrd, readNrrd } from './nrrd.js';
import { rawInfo } from './raw.js';
import { FileError, requireSize, volumeBytes } from './volume_info.js';

/**
 * @callback Reader
 * @param {string} name
 * @param {import('./bytes.js').ByteSource} source at the beginning of the file
 * @param {(name: string) => Promise<import('./bytes.js').ByteSource>} others opens a file beside
 * @returns {Promise<{info: any, data: import('./bytes.js').ByteSource}>} what it is, and its samples
 */

/** @type {{is: (head: Uint8Array) => boolean, read: Reader}[]} */
const formats = [
  { is: isNrrd, read: readNrrd },
  { is: isNifti, read: readNifti },
  { is: isMetaImage, read: readMetaImage },
  { is: isNpy, read: readNpy },
];

const headBytes = 540;

/** A file of unknown format: the page asks for its layout. */
export class UnknownLayout extends Error {
  /** @param {File} file */
  constructor(file) {
    super(`${file.name}: no known header`);
    this.file = file;
  }
}

/**
 * @param {File[]} files
 * @param {import('./raw.js').RawLayout} [layout] of headerless samples
 * @returns {Promise<{name: string, info?: import('./volume_info.js').VolumeInfo,
 *   mesh?: import('./glb.js').DrawnMesh, data?: import('./bytes.js').ByteSource}>} with neither,
 *   a stream
 */
export async function openFiles(files, layout) {
  const others = async (/** @type {string} */ path) => {
    const wanted = path.split(/[\\/]/).pop();
    const file = files.find((each) => each.name === wanted);
    if (!file)
      throw new FileError(files[0].name, `its samples are in ${wanted}`, 'open both files together');
    return openBytes(file);
  };
  for (const file of files) {
    const data = await openBytes(file);
    const name = file.name;
    if (layout) {
      const info = /** @type {any} */ (rawInfo(layout));
      requireRawSize(file, info);
      return { name, info, data };
    }
    const head = await data.peek(headBytes);
    if (/\.dmc$/i.test(name)) return { name, data };
    if (isGlb(head)) return { name, mesh: await readGlb(name, data) };
    if (isDicom(head)) {
      data.cancel();
      const series = await readDicom(files);
      requireSize(series.name, series.info);
      return series;
    }
    const format = formats.find(({ is }) => is(head));
    if (format) {
      const volume = await format.read(name, data, others);
      requireSize(name, volume.info);
      return { name, ...volume };
    }
    data.cancel();
  }
  const named = files.find((file) => /\.(raw|bin|img)(\.gz)?$/i.test(file.name));
  if (named) throw new UnknownLayout(named);
  throw new FileError(files[0].name, 'the format is unknown',
    'open NRRD, NIfTI, MetaImage, NumPy, DICOM, headerless samples (.raw), a stream (.dmc) or a mesh ' +
      '(.glb); discmc view makes a page of other formats');
}

/** @param {File} file @param {import('./volume_info.js').VolumeInfo} info */
function requireRawSize(file, info) {
  requireSize(file.name, info);
  if (!/\.gz$/i.test(file.name) && file.size !== volumeBytes(info))
    throw new FileError(file.name,
      `the file has ${file.size} bytes, and ${info.dims.join(' x ')} of ${info.type} need ${volumeBytes(info)}`,
      'correct the voxels and the type');
}
