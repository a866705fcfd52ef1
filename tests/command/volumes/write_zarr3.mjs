// Writes the volume of write_volumes.py as OME-Zarr 0.5, which is of version 3 of Zarr, with a
// program that has nothing to do with discmc. Run it again only to add files:
//
//   npm install zarrita @zarrita/storage && node tests/command/volumes/write_zarr3.mjs
import {fileURLToPath} from 'node:url';
import FileSystemStore from '@zarrita/storage/fs';
import * as zarr from 'zarrita';

const spacing = [2, 0.75, 0.5];
const origin = [30.5, -20, 10];
const types = {
  u8: ['uint8', Uint8Array, (i) => i * 4],
  i16: ['int16', Int16Array, (i) => i * 1000 - 30000],
  f32: ['float32', Float32Array, (i) => i * 0.25 - 7.5],
};

async function write(name, how, options) {
  const folder = fileURLToPath(new URL(`zarr/${name}-little-version3${how}.zarr`, import.meta.url));
  const root = zarr.root(new FileSystemStore(folder));
  const axes = ['z', 'y', 'x'].map((axis) => ({name: axis, type: 'space', unit: 'millimeter'}));
  const transformations = [
    {type: 'scale', scale: spacing},
    {type: 'translation', translation: origin},
  ];
  const datasets = [{path: '0', coordinateTransformations: transformations}];
  const ome = {version: '0.5', multiscales: [{axes, datasets}]};
  await zarr.create(root, {attributes: {ome}});
  const [dtype, Samples, value] = types[name];
  const array = await zarr.create(root.resolve('0'),
      {shape: [4, 3, 5], dtype, dimensionNames: ['z', 'y', 'x'], fillValue: 0, ...options});
  const data = Samples.from({length: 60}, (_, i) => value(i));
  await zarr.set(array, null, {data, shape: [4, 3, 5], stride: [15, 5, 1]});
}

const bytes = {name: 'bytes', configuration: {endian: 'little'}};
const blosc = {
  name: 'blosc',
  configuration: {cname: 'zstd', clevel: 5, shuffle: 'shuffle', typesize: 2, blocksize: 0},
};
const zstd = {name: 'zstd', configuration: {level: 3, checksum: false}};
const transpose = {name: 'transpose', configuration: {order: [2, 0, 1]}};
for (const name in types) await write(name, '', {chunkShape: [4, 3, 5], codecs: [bytes]});
await write('i16', '-blosc', {chunkShape: [3, 2, 3], codecs: [bytes, blosc]});
await write('i16', '-zstd', {chunkShape: [4, 2, 5], codecs: [bytes, zstd]});
await write('i16', '-transpose', {chunkShape: [2, 3, 4], codecs: [transpose, bytes]});
