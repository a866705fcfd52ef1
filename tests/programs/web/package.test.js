// The npm package, packed and installed like by a program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createServer } from 'node:http';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { nrrdOf, roughBall } from './ball.js';
import { command } from './command.js';

const folder = mkdtempSync(join(tmpdir(), 'discmc-package-'));
after(() => rmSync(folder, { recursive: true }));
const installed = join(folder, 'node_modules/discmc');
const ball = roughBall();
let discmc;

before(async () => {
  const npm = (...words) => execFileSync('npm', words, { cwd: folder, encoding: 'utf8' });
  const packed = npm('pack', '--silent', process.env.DISCMC_PACKAGE).trim();
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  npm('install', '--silent', '--offline', '--no-audit', '--no-fund', join(folder, packed));
  const { load } = await import(pathToFileURL(join(installed, 'index.js')).href);
  discmc = await load();
});

// Six times the enclosed volume; every edge occurs once in each direction.
function volumeOfClosed({ positions, triangles }) {
  const edges = new Map();
  let volume = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = triangles.subarray(i, i + 3);
    for (const [from, to] of [[a, b], [b, c], [c, a]]) {
      const edge = Math.min(from, to) * 2 ** 26 + Math.max(from, to);
      edges.set(edge, (edges.get(edge) ?? 0) + (from < to ? 1 : -1));
    }
    const [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] =
      [a, b, c].map((corner) => positions.subarray(3 * corner, 3 * corner + 3));
    volume += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  assert.ok([...edges.values()].every((sum) => sum === 0), 'the mesh is closed');
  return volume;
}

test('a mesh has the triangles and the volume that the command prints', () => {
  const file = join(folder, 'ball.nrrd');
  writeFileSync(file, nrrdOf(ball));
  const table = join(folder, 'ball.json');
  command('extract', '--quiet', file, '--iso', '400', '-o', table);
  const [expected] = JSON.parse(readFileSync(table, 'utf8'));
  const mesh = discmc.extract(ball.samples, ball.dims, 400, { spacing: ball.spacing });
  assert.ok(Math.abs(volumeOfClosed(mesh) / 6 / expected.volume_mm3 - 1) < 1e-5);
});

test('every type of typed arrays gives the same surface', () => {
  const { triangles } = discmc.extract(ball.samples, ball.dims, 400);
  for (const Type of [Int32Array, Float32Array, Float64Array])
    assert.deepEqual(discmc.extract(Type.from(ball.samples), ball.dims, 400).triangles, triangles);
  const big = BigInt64Array.from(ball.samples, BigInt);
  assert.deepEqual(discmc.extract(big, ball.dims, 400).triangles, triangles);
});

test('a wrong array is refused with its value and the remedy', () => {
  assert.throws(() => discmc.extract([1, 2], [2, 1, 1], 1), /no typed array; give one/);
  assert.throws(() => discmc.extract(new Uint8Array(7), [2, 2, 2], 1), /7 samples, and 2 x 2 x 2 are 8/);
  assert.throws(() => discmc.extract(new Uint8Array(8), [0, 2, 2], 1), /an extent is 0; give/);
});

test('a decoder returns the mesh so far, and the whole mesh at the end', async () => {
  const file = join(folder, 'ball.nrrd');
  const stream = join(folder, 'ball.dmc');
  command('extract', '--quiet', file, '--iso', '400', '-o', stream);
  const bytes = readFileSync(stream);
  const decoder = await discmc.decoder();
  decoder.push(bytes.subarray(0, bytes.length / 2));
  const half = decoder.mesh().triangles.length;
  decoder.push(bytes.subarray(bytes.length / 2));
  assert.ok(decoder.finish().isComplete);
  const whole = decoder.mesh();
  assert.ok(half > 0 && half < whole.triangles.length);
  const mesh = discmc.extract(ball.samples, ball.dims, 400, { spacing: ball.spacing });
  assert.ok(Math.abs(volumeOfClosed(whole) / volumeOfClosed(mesh) - 1) < 1e-5);
});

test('meshes of a stream with fractions equal those of the command, also with mirrored axes', async () => {
  const file = join(folder, 'turned.nrrd'), stream = join(folder, 'fractions.dmc');
  const [expected, table] = [join(folder, 'expected.stl'), join(folder, 'expected.json')];
  writeFileSync(file, nrrdOf({ ...ball, spacing: [0.5, -0.75, 1.25] }));
  command('extract', '--quiet', file, '--iso', '400', '--wire', 'slices', '--levels', '4', '-o', stream);
  const decoder = await discmc.decoder();
  decoder.push(readFileSync(stream));
  assert.equal(decoder.finish().levels, 4);
  for (const surface of ['relaxed', 'interpolated']) {
    command('decode', stream, '--surface', surface, '-o', expected);
    command('decode', stream, '--surface', surface, '-o', table);
    const mesh = decoder.mesh({ surface });
    assert.equal(mesh.triangles.length / 3, (readFileSync(expected).length - 84) / 50);
    const [{ volume_mm3: volume }] = JSON.parse(readFileSync(table, 'utf8'));
    assert.ok(Math.abs(volumeOfClosed(mesh) / 6 / volume - 1) < 1e-5, `${surface}: ${volume}`);
    assert.equal(mesh.normals.length, mesh.positions.length);
  }
  assert.throws(() => decoder.mesh({ surface: 'smooth' }), /'smooth'; give/);
});

test('a stream without fractions is relaxed, not interpolated', async () => {
  const decoder = await discmc.decoder();
  decoder.push(readFileSync(join(folder, 'ball.dmc')));
  assert.equal(decoder.finish().levels, 0);
  volumeOfClosed(decoder.mesh({ surface: 'relaxed' }));
  assert.throws(() => decoder.mesh({ surface: 'interpolated' }), /no fractions to interpolate: give 'relaxed'/);
});

test('the programs of its page print the meshes of an array and of a stream', () => {
  const page = readFileSync(join(installed, 'README.md'), 'utf8');
  const [[, ofArray], [, ofStream]] = page.matchAll(/```js\n([^]*?)```/g);
  const printed = (program) => {
    writeFileSync(join(folder, 'program.js'), program);
    return execFileSync(process.execPath, ['program.js'], { cwd: folder, encoding: 'utf8' });
  };
  assert.match(printed(ofArray), /^\d{4} vertices, \d{4,5} triangles\n$/);
  const port = `import { createReadStream } from 'node:fs';
    import { load } from 'discmc';
    const discmc = await load(), port = createReadStream('ball.dmc');`;
  assert.match(printed(port + ofStream), /^true \d{4,5}\n$/);
});

test('the package runs in a browser', { skip: !process.env.DISCMC_CHROMIUM }, async (t) => {
  const { startBrowser } = await import('./browser.js');
  const types = { js: 'text/javascript', wasm: 'application/wasm', html: 'text/html' };
  const server = createServer(({ url }, answer) => {
    const name = url === '/' ? undefined : url.slice(1);
    answer.setHeader('Content-Type', types[name?.split('.').pop() ?? 'html'] ?? 'text/plain');
    answer.end(name === undefined ? '<!doctype html>' : ['index.js', 'discmc.wasm'].includes(name)
      ? readFileSync(join(installed, name)) : '');
  });
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
  t.after(() => server.close());
  const browser = await startBrowser();
  t.after(() => browser.close());
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  const count = await page.evaluate(async () => {
    const { load } = await import('/index.js');
    const samples = new Uint8Array(27);
    samples[13] = 1;
    return (await load()).extract(samples, [3, 3, 3], 1).triangles.length / 3;
  });
  assert.equal(count, 8);
});
