// The module makes the same surfaces of volumes as the command.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { nrrdOf, roughBall } from './ball.js';
import { command, polygonsByCommand, workFolder } from './command.js';
import { openVolume, polygonsOf, startModule } from './module_of_page.js';

const folder = workFolder(after);
const file = join(folder, 'ball.nrrd');
const ball = roughBall();
writeFileSync(file, nrrdOf(ball));

test('at 40 thresholds, the polygons equal those of the command, ring by ring', async () => {
  const { module } = await openVolume(file);
  for (let step = 0; step < 40; ++step) {
    const iso = -400 + 37.5 * step;
    module.extract(iso, false);
    assert.equal(await polygonsOf(module), polygonsByCommand(folder, 'extract', '--quiet', file, '--iso', `${iso}`),
      `threshold ${iso}`);
  }
});

test('with the noise filter, the polygons equal those of the command', async () => {
  const { module } = await openVolume(file);
  module.extract(400, true);
  assert.equal(await polygonsOf(module),
    polygonsByCommand(folder, 'extract', '--quiet', file, '--iso', '400', '--median', '3'));
});

test('the CT head at 40 thresholds, if the file is present', async (t) => {
  const head = join(process.env.DISCMC_DATA ?? '', 'cthead.nrrd');
  if (!process.env.DISCMC_DATA || !existsSync(head)) return t.skip('DISCMC_DATA is not set');
  const { module } = await openVolume(head);
  for (let step = 0; step < 40; ++step) {
    const iso = 300 + 30 * step;
    module.extract(iso, false);
    assert.ok(await polygonsOf(module) === polygonsByCommand(folder, 'extract', '--quiet', head, '--iso', `${iso}`),
      `threshold ${iso}`);
  }
});

test('the mesh is closed: every edge occurs once in each direction', async () => {
  const { module } = await openVolume(file);
  module.extract(400, false);
  const { vertices, triangles, leftOut } = module.draw();
  assert.equal(leftOut, 0);
  const places = new Int16Array(vertices.buffer);
  const corners = new Uint32Array(triangles.buffer);
  assert.ok(corners.length > 3000);
  const edges = new Map();
  const place = (corner) => places.subarray(4 * corner, 4 * corner + 3).join();
  for (let i = 0; i < corners.length; i += 3)
    for (let side = 0; side < 3; ++side) {
      const [a, b] = [place(corners[i + side]), place(corners[i + ((side + 1) % 3)])];
      const [edge, step] = a < b ? [`${a} ${b}`, 1] : [`${b} ${a}`, -1];
      edges.set(edge, (edges.get(edge) ?? 0) + step);
    }
  assert.ok([...edges.values()].every((sum) => sum === 0));
});

test('classic Marching Cubes has the triangles that the sweep counts', async () => {
  const { module } = await openVolume(file);
  const { classicTriangles } = module.extract(400, false);
  assert.equal(module.classic().triangles.length, 12 * classicTriangles);
});

test('gradient normals point away from the middle of a ball', async () => {
  const { module } = await openVolume(file);
  module.extract(400, false);
  const { vertices } = module.draw();
  const places = new Int16Array(vertices.buffer);
  const normals = module.normals();
  assert.equal(normals.length, vertices.length / 4);
  let away = 0;
  for (let i = 0; i < normals.length / 2; ++i) {
    const [u, v] = [(normals[2 * i] - 128) / 127, (normals[2 * i + 1] - 128) / 127];
    const z = 1 - Math.abs(u) - Math.abs(v);
    const fold = (at, other) => (z < 0 ? (1 - Math.abs(other)) * (at < 0 ? -1 : 1) : at);
    const normal = [fold(u, v), fold(v, u), z];
    const from = ball.dims.map((extent, axis) =>
      (places[4 * i + axis] - extent) * ball.spacing[axis]);
    away += normal.reduce((sum, part, axis) => sum + part * from[axis], 0) > 0 ? 1 : 0;
  }
  assert.ok(away > 0.9 * (normals.length / 2), `${away} of ${normals.length / 2}`);
});

test('less memory makes the stream longer; the polygons are unchanged', async () => {
  const { module } = await openVolume(file);
  module.extract(400, false);
  const expected = await polygonsOf(module);
  const rich = module.scan(64 << 20), richStream = module.stream();
  const poor = module.scan(module.leastMemory()), poorStream = module.stream();
  assert.equal(rich.fragments, 0);
  assert.ok(poor.fragments > 0 && poor.bytes > rich.bytes);
  const slices = module.scan(0), slicesStream = module.stream();
  assert.ok(slices.bytes < rich.bytes);
  for (const stream of [richStream, poorStream, slicesStream]) {
    const path = join(folder, 'scan.dmc');
    writeFileSync(path, stream);
    assert.equal(polygonsByCommand(folder, 'decode', path), expected);
    const decoded = await startModule();
    decoded.newStream();
    decoded.pushStream(stream);
    const report = decoded.endStream();
    assert.ok(report.isComplete);
    assert.deepEqual(report.dims, ball.dims);
    assert.equal(await polygonsOf(decoded), expected);
    assert.equal(decoded.draw().leftOut, 0);
  }
});

test('a link with several surfaces shows the chosen one', async () => {
  for (const wire of ['regions', 'slices']) {
    const path = join(folder, 'several.dmc');
    command('extract', file, '--iso', '200', '--iso', '600', '--scan', '7', '-o', path, '--quiet', '--wire', wire);
    for (const choice of [undefined, { scan: 7, channel: 0 }, { scan: 7, channel: 1 }]) {
      const module = await startModule();
      module.newStream(choice);
      module.pushStream(readFileSync(path));
      const iso = choice?.channel === 1 ? 600 : 200;
      assert.equal(module.endStream().threshold, iso);
      assert.deepEqual(module.streamSurfaces(),
        [{ scan: 7, channel: 0, threshold: 200 }, { scan: 7, channel: 1, threshold: 600 }]);
      assert.equal(await polygonsOf(module),
        polygonsByCommand(folder, 'decode', path, '--stream-channel', `${choice?.channel ?? 0}`));
    }
  }
});

test('a stream keeps the upward direction of its volume', async () => {
  for (const [space, directions] of [['left-posterior-superior', '(0,0.5,0) (0,0,0.5) (1,0,0)'],
    ['right-anterior-superior', '(0.5,0,0) (0,0.5,0) (0,0,1)'],
    ['left-posterior-superior', '(-0.5,0,0) (0,0,-0.5) (0,-1,0)']]) {
    const path = join(folder, 'placed.nrrd');
    writeFileSync(path, nrrdOf(ball).toString('latin1').replace(/spacings: .*\n/,
      `space: ${space}\nspace directions: ${directions}\n`), 'latin1');
    command('extract', path, '--iso', '400', '-o', join(folder, 'placed.dmc'), '--quiet');
    const module = await startModule();
    module.newStream();
    module.pushStream(readFileSync(join(folder, 'placed.dmc')));
    const { spacing, upright } = module.endStream();
    const { info } = await openVolume(path);
    assert.deepEqual([spacing, upright], [info.spacing, info.upright]);
  }
});

test('the missing parts of a damaged stream are reported, and the whole ones are decoded', async () => {
  for (const wire of ['regions', 'slices']) {
    const path = join(folder, 'damaged.dmc');
    command('extract', file, '--iso', '400', '-o', path, '--quiet', '--wire', wire);
    const bytes = readFileSync(path);
    bytes.fill(0x55, bytes.length >> 1, (bytes.length >> 1) + 300);
    const module = await startModule();
    module.newStream();
    module.pushStream(bytes);
    const report = module.endStream();
    assert.ok(report.hasHeader && !report.isComplete);
    assert.ok(report.lostPackets > 0 && report.polygons > 0);
    assert.equal(module.draw().leftOut, 0);
  }
});

test('any bytes after a header end in a report or an error', async () => {
  const path = join(folder, 'whole.dmc');
  command('extract', file, '--iso', '400', '-o', path, '--quiet');
  const whole = readFileSync(path);
  for (let seed = 1; seed < 30; ++seed) {
    const bytes = Buffer.from(whole);
    for (let i = 0; i < 40; ++i) bytes[(seed * 7919 * (i + 1)) % bytes.length] ^= seed + i;
    const module = await startModule();
    module.newStream();
    module.pushStream(bytes);
    module.endStream();
    module.draw();
  }
});

test('the statistics of samples equal those of the command', async () => {
  const { module } = await openVolume(file);
  const { least, greatest, otsu, automatic, histogram } = module.measure();
  const told = command('info', file).toString();
  assert.match(told, new RegExp(`^range ${least} ${greatest}$`, 'm'));
  assert.match(told, new RegExp(`^proposal --iso=${otsu} otsu`, 'm'));
  assert.equal(automatic, 300); // from air to bone: these are Hounsfield units
  assert.equal(histogram.reduce((a, b) => a + b), ball.samples.length);
});
