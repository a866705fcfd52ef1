// The page's readers read the same files as the command's, or refuse them with a reason.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { gunzipSync } from 'node:zlib';
import { openFiles } from '../../../ports/web/page/formats/volume_file.js';
import { polygonsByCommand, workFolder, command } from './command.js';
import { asFile, openVolume, polygonsOf } from './module_of_page.js';
import { nrrdOf, roughBall } from './ball.js';

const folder = workFolder(after);
const volumes = new URL('../../command/volumes/', import.meta.url).pathname;

// The description of a file, as the command prints it.
function assertSpacing(spacing, path) {
  const told = /^spacing (.*)$/m.exec(command('info', path).toString())[1].split(' ').map(Number);
  spacing.forEach((step, axis) =>
    assert.ok(Math.abs(step - told[axis]) < 1e-6, `${spacing}, and the command has ${told}`));
}

const files = ['nrrd', 'metaimage', 'nifti1', 'nifti2', 'numpy'].flatMap((format) =>
  readdirSync(join(volumes, format)).map((name) => join(format, name)));
const isRefused = /text|bzip2|frame1/;
const isData = /\.(img|raw|raw\.gz)$/;

for (const file of files.filter((each) => !isData.test(each))) {
  const path = join(volumes, file);
  if (isRefused.test(file))
    test(`${file} is refused by its name, with a remedy`, () =>
      assert.rejects(openVolume(path), /^FileError: [\w.-]+: .+; .+$/s));
  else
    test(`${file} is read as the command reads it`, async () => {
      const beside = files.filter((each) => isData.test(each) && each.startsWith(file.split('.')[0]))
        .map((each) => join(volumes, each));
      const { info, module } = await openVolume([path, ...beside]);
      const { automatic } = module.measure();
      module.extract(automatic, false);
      assert.equal(await polygonsOf(module),
        polygonsByCommand(folder, 'extract', '--quiet', path, '--iso', 'auto'));
      assertSpacing(info.spacing, path);
    });
}

test('the file name proposes the layout of headerless samples', async () => {
  const ball = roughBall();
  const path = join(folder, 'ball_48x40x36_i16.raw');
  writeFileSync(path, Buffer.from(ball.samples.buffer));
  await assert.rejects(openFiles([asFile(path)]), /no known header/);
  const { proposedLayout } = await import('../../../ports/web/page/formats/raw.js');
  const layout = proposedLayout('ball_48x40x36_i16.raw', ball.samples.byteLength);
  assert.deepEqual(layout, { dims: [48, 40, 36], type: 'i16', bigEndian: false, spacing: [1, 1, 1] });
  const { module } = await openVolume(path, layout);
  module.extract(400, false);
  assert.equal(await polygonsOf(module), polygonsByCommand(folder, 'extract', '--quiet', path, '--dims',
    '48,40,36', '--type', 'i16', '--iso', '400'));
});

test('sizes beyond memory are refused before anything is allocated', async () => {
  const path = join(folder, 'huge.nrrd');
  writeFileSync(path, nrrdOf({ dims: [16000, 16000, 16000], spacing: [1, 1, 1], samples: new Int16Array(9) }));
  await assert.rejects(openVolume(path), /16000 x 16000 x 16000 voxels are .* MiB; .*at most 1,024 MiB; .*--shrink/);
});

const aNifti = readFileSync(join(volumes, 'nifti1', 'i16-little.nii'));
const changed = (change) => {
  const bytes = Buffer.from(aNifti);
  change(bytes);
  return bytes;
};
const wrongHeaders = {
  'lines.nrrd': [nrrdOf(roughBall(8, 8, 8), 'line skip: 1e999\n'), /line skip is Infinity, but the file has .* lines; correct/],
  'short.npy': [Buffer.from('\x93NUMPY', 'latin1'), /cut off; save/],
  'half.npy': [Buffer.from("\x93NUMPY\x01\0\x40\0{'descr': '<f2', 'shape': (1, 1, 1), }", 'latin1'), /not of numbers; save/],
  'none.nii': [changed((bytes) => bytes.writeInt16LE(0, 40)), /declares 0 dimensions; correct/],
  'nowhere.nii': [changed((bytes) => bytes.writeFloatLE(NaN, 108)), /vox_offset is NaN; correct/],
};
for (const [name, [bytes, message]] of Object.entries(wrongHeaders))
  test(`${name} is refused for its header`, { timeout: 10000 }, async () => {
    const path = join(folder, name);
    writeFileSync(path, bytes);
    await assert.rejects(openVolume(path), message);
  });

test('a truncated volume is refused with the number of missing bytes', async () => {
  const path = join(folder, 'cut.nrrd');
  writeFileSync(path, nrrdOf({ dims: [16, 16, 16], spacing: [1, 1, 1], samples: new Int16Array(9) }));
  await assert.rejects(openVolume(path), /ends after 18 bytes/);
});

test('the axes of oblique and mirrored volumes equal those of the command', async () => {
  const backwards = join(folder, 'backwards.nrrd');
  writeFileSync(backwards, nrrdOf({ ...roughBall(8, 8, 8), spacing: [0.5, -0.75, 1.25] }));
  assertSpacing((await openFiles([asFile(backwards)])).info.spacing, backwards);
  const directions = [
    '(-0.5,0,0) (0,0.75,0) (0,0,1.25)', '(0.35,0.35,0) (-0.35,0.35,0) (0,0,1.25)',
    '(0,0.75,0) (0.5,0,0) (0,0,1.25)', '(0.5,0.1,0) (-0.1,0.75,0) (0,0,-1.25)',
  ];
  for (const each of directions) {
    const path = join(folder, 'turned.nrrd');
    const ball = roughBall(8, 8, 8);
    const file = nrrdOf(ball).toString('latin1').replace(/spacings: .*\n/,
      `space: left-posterior-superior\nspace directions: ${each}\n`);
    writeFileSync(path, file, 'latin1');
    const { info } = await openFiles([asFile(path)]);
    assertSpacing(info.spacing, path);
  }
});

test('left, posterior and superior are labelled as in the surface', async () => {
  const oblique = Math.SQRT1_2;
  for (const [space, directions, expected] of [
    ['left-posterior-superior', '(1,0,0) (0,2,0) (0,0,3)', [[1, 0, 0], [0, 1, 0], [0, 0, 1]]],
    ['right-anterior-superior', '(1,0,0) (0,2,0) (0,0,3)', [[-1, 0, 0], [0, -1, 0], [0, 0, 1]]],
    ['left-posterior-superior', '(-1,0,0) (0,-2,0) (0,0,3)', [[1, 0, 0], [0, 1, 0], [0, 0, 1]]],
    ['left-posterior-superior', '(0,1,0) (0,0,2) (3,0,0)', [[0, 0, 1], [1, 0, 0], [0, 1, 0]]],
    ['left-posterior-superior', `(1,0,0) (0,${oblique},${oblique}) (0,${-oblique},${oblique})`,
      [[1, 0, 0], [0, oblique, -oblique], [0, oblique, oblique]]]]) {
    const path = join(folder, 'placed.nrrd');
    writeFileSync(path, nrrdOf(roughBall(8, 8, 8)).toString('latin1').replace(/spacings: .*\n/,
      `space: ${space}\nspace directions: ${directions}\n`), 'latin1');
    const { info } = await openFiles([asFile(path)]);
    info.upright.flat().forEach((part, i) =>
      assert.ok(Math.abs(part - expected.flat()[i]) < 1e-12, `${directions}: ${info.upright}`));
  }
  const path = join(folder, 'unplaced.nrrd');
  writeFileSync(path, nrrdOf(roughBall(8, 8, 8)));
  assert.equal((await openFiles([asFile(path)])).info.upright, undefined);
});

test('a page contains the directions of its volume, if the volume has any', async () => {
  for (const header of ['', 'space: left-posterior-superior\nspace directions: (0,0.5,0) (0,0,2) (1,0,0)\n']) {
    const path = join(folder, 'v.nrrd');
    writeFileSync(path, nrrdOf({ ...roughBall(8, 8, 8), spacing: [0.5, -0.75, 1.25] }).toString('latin1')
      .replace(header ? /spacings: .*\n/ : /^$/, header), 'latin1');
    const page = command('view', path, '-o', '-').toString();
    const inside = /data-encoding="gzip">([^<]*)</.exec(page)[1];
    const file = Object.assign(new Blob([gunzipSync(Buffer.from(inside, 'base64'))]), { name: 'v.nii' });
    const { info } = await openFiles([file]), own = (await openFiles([asFile(path)])).info;
    const withoutSignsOfZero = (rows) => rows?.map((row) => row.map((part) => part + 0));
    assert.deepEqual(withoutSignsOfZero(info.upright), withoutSignsOfZero(own.upright));
    assert.equal(info.upright === undefined, header === '');
    if (!header) assert.deepEqual(info.spacing, own.spacing);
  }
});

const dicom = join(volumes, 'dicom');
const imagesIn = (folder) => readdirSync(join(dicom, folder)).map((name) => join(dicom, folder, name));

for (const [name, paths] of [['series', imagesIn('series')], ['scaled', imagesIn('scaled')],
  ...['u16', 'u8', 'big', 'implicit', 'little', 'u16-jpeg', 'u8-jpeg', 'u16-rle', 'u8-rle'].map((name) => [`${name}.dcm`, [join(dicom, `${name}.dcm`)]])])
  test(`dicom/${name} is read as the command reads it`, async () => {
    const { info, module } = await openVolume(paths.reverse());
    const { otsu } = module.measure();
    module.extract(otsu, false);
    assert.equal(await polygonsOf(module),
      polygonsByCommand(folder, 'extract', '--quiet', join(dicom, name), '--iso', 'otsu'));
    assertSpacing(info.spacing, join(dicom, name));
  });

for (const name of ['u16-j2k', 'u16-jpegls', 'u8-lossy', 'colour', 'deflated', 'report'])
  test(`dicom/${name}.dcm is refused with a remedy`, () =>
    assert.rejects(openVolume(join(dicom, `${name}.dcm`)), /^FileError: .+: .+; .+$/s));

test('a series with a slice that is missing in its middle is refused', async () => {
  const images = imagesIn('series');
  const opened = await Promise.allSettled(images.map((left) =>
    openVolume(images.filter((image) => image !== left))));
  const reasons = opened.flatMap(({ reason }) => (reason ? [reason.message] : []));
  assert.equal(reasons.length, images.length - 2, 'all but the first and the last');
  for (const reason of reasons) assert.match(reason, /mm away, and others .*--allow-gaps/);
});

test('a mesh that the command writes is read whole: positions, normals, triangles, name and colour', async () => {
  const path = join(folder, 'mesh.nrrd'), glb = join(folder, 'mesh.glb'), obj = join(folder, 'mesh-{name}.obj');
  writeFileSync(path, nrrdOf(roughBall(20, 18, 16)).toString('latin1').replace(/spacings: .*\n/,
    'space: left-posterior-superior\nspace directions: (0,0.5,0) (-1,0,0) (0,0,2)\n' +
    'space origin: (1000,-2000,3000.5)\n'), 'latin1');
  const table = join(folder, 'table.txt');
  writeFileSync(table, '700 top 10 200 30\n');
  const words = ['--quiet', '--labels', '700', '--label-table', table, '--normals', 'surface'];
  command('extract', path, ...words, '-o', glb);
  command('extract', path, ...words, '-o', obj);
  const lines = readFileSync(obj.replace('{name}', 'top'), 'utf8').split('\n').map((line) => line.split(' '));
  const numbers = (key) => lines.filter(([first]) => first === key)
    .flatMap((line) => line.slice(1).map(parseFloat));
  const { name, mesh } = await openFiles([asFile(glb)]);
  assert.equal(name, 'mesh.glb');
  assert.deepEqual(mesh.parts.map((part) => part.name), ['top']);
  assert.deepEqual([...mesh.colours.subarray(-4)], [10, 200, 30, 255]);
  assert.deepEqual([...mesh.triangles].map((corner) => corner + 1), numbers('f'));
  const isNear = (values, expected, tolerance) => {
    assert.equal(values.length, expected.length);
    values.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < tolerance, `${value}, ${expected[i]}`));
  };
  isNear([...mesh.places].map((at, i) => mesh.origin[i % 3] + (at * mesh.step) / 2), numbers('v'), 1e-3);
  isNear([...mesh.normals], numbers('vn'), 1e-5);
});

test('glTF in another form than the command writes is refused with a remedy', async () => {
  const glbOf = (json) => {
    const text = JSON.stringify(json).padEnd(400);
    const head = new Uint32Array([0x46546c67, 2, 28 + text.length, text.length, 0x4e4f534a]);
    const end = new Uint32Array([0, 0x004e4942]);
    return Object.assign(new Blob([head, text, end]), { name: 'other.glb' });
  };
  const scene = { scenes: [{ nodes: [0] }], meshes: [{ primitives: [] }] };
  await assert.rejects(openFiles([glbOf({ ...scene, nodes: [{ mesh: 0, scale: [1, 1, 1] }] })]),
    /^FileError: other.glb: the layout of its nodes .*; convert it with discmc view FILE.glb/);
  await assert.rejects(openFiles([glbOf({})]), /^FileError: other.glb: the file holds no mesh; /);
  await assert.rejects(openFiles([Object.assign(new Blob([await glbOf({}).arrayBuffer().then((all) =>
    all.slice(0, 100))]), { name: 'cut.glb' })]), /^FileError: cut.glb: the file is cut off/);
});
