// Pages of the command with data inside.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { nrrdOf, roughBall } from './ball.js';
import { checkAccess, hasSurface, openFiles, pageTests, pixelsOf, rested, saved, shownPolygons } from './browser.js';
import { command, polygonsByCommand, workFolder } from './command.js';

const folder = workFolder(after);
const volume = join(folder, 'ball.nrrd');
writeFileSync(volume, nrrdOf(roughBall()));
const path = join(folder, 'page.html');

const { withPage, onPage } = pageTests();

/** Opens the page that the command makes; returns its name of the open file, and its polygons. */
async function viewed(...words) {
  command('view', ...words, '-o', path, '--no-open');
  return withPage({ path }, async (page) => {
    await hasSurface(page);
    const opened = await page.textContent('#file-name');
    const isVolume = await page.isVisible('#threshold');
    const iso = isVolume ? Number(await page.inputValue('#threshold-number')) : undefined;
    return { opened, iso, polygons: await shownPolygons(page) };
  });
}

test('a page made without a threshold offers all thresholds', async () => {
  const { opened, iso, polygons } = await viewed(volume);
  assert.equal(opened, 'ball.nrrd · 48 × 40 × 36 voxels of 0.5 × 0.75 × 1.25 mm');
  assert.equal(polygons, polygonsByCommand(folder, 'extract', '--quiet', volume, '--iso', `${iso}`));
});

test('a page made with --iso shows that surface', async () => {
  const { opened, polygons } = await viewed(volume, '--iso', '400');
  assert.match(opened, /^ball.nrrd at 400.dmc · 48 × 40 × 36 voxels/);
  assert.equal(polygons, polygonsByCommand(folder, 'extract', '--quiet', volume, '--iso', '400'));
});

test('a page of a stream shows its polygons', async () => {
  const stream = join(folder, 'ball.dmc');
  command('extract', '--quiet', volume, '--iso', '400', '-o', stream);
  const { opened, polygons } = await viewed(stream);
  assert.match(opened, /^ball.dmc · /);
  assert.equal(polygons, polygonsByCommand(folder, 'decode', stream));
});

/** A volume of two labels beside each other along x, which have names and colours. */
const labels = join(folder, 'labels.nrrd');
const dims = [24, 16, 16];
writeFileSync(labels, nrrdOf({ dims, spacing: [1, 1, 1], samples: new Int16Array(dims[0] * 256).map((_, i) => {
  const [x, y, z] = [i % 24, Math.floor(i / 24) % 16, Math.floor(i / 384)];
  const isIn = [x, y, z].every((at, axis) => at > 2 && at < dims[axis] - 3);
  return isIn ? (x < 12 ? 1 : 2) : 0;
}) }, 'space: left-posterior-superior\n').toString('latin1').replace(/spacings: .*\n/,
  'space directions: (1,0,0) (0,1,0) (0,0,1)\nSegment0_LabelValue:=1\nSegment0_Name:=left part\n' +
  'Segment0_Color:=1 0 0\nSegment1_LabelValue:=2\nSegment1_Name:=right part\nSegment1_Color:=0 1 0\n'), 'latin1');

/** How many pixels are red, green, and how many different colours there are. */
async function coloursOf(page) {
  const data = await pixelsOf(page);
  const count = { red: 0, green: 0 };
  const all = new Set();
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] === 0) continue;
    if (data[i] > 3 * data[i + 1]) ++count.red;
    if (data[i + 1] > 3 * data[i]) ++count.green;
    all.add(data.readUInt32BE(i));
  }
  return { ...count, different: all.size };
}

const small = { width: 800, height: 400 };

test('labels have their colours and names; they are smooth first, and flat after a click', async () => {
  command('view', labels, '--labels', 'all', '-o', path, '--no-open');
  await withPage({ path, viewport: small }, async (page) => {
    assert.equal(await page.textContent('#file-name'), 'labels.nrrd · 18 × 10 × 10 mm');
    assert.deepEqual(await page.locator('#labels span').allTextContents(), ['left part', 'right part']);
    assert.match(await page.textContent('#caption-merged'), /^\d+ triangles$/);
    await rested(page);
    const smooth = await coloursOf(page);
    assert.ok(smooth.red > 2000 && smooth.green > 2000, `${smooth.red} red, ${smooth.green} green`);
    await page.uncheck('#smooth');
    const flat = await coloursOf(page);
    assert.ok(flat.red > 2000 && flat.different < smooth.different / 3,
      `${flat.different} colours, and ${smooth.different} when smooth`);
    await page.check('#edges');
    const edged = await coloursOf(page);
    assert.ok(edged.different > flat.different);
  });
});

test('a mesh can be measured in its coordinates and cut, and a volume replaces it', async () => {
  const stl = join(folder, 'placed.stl');
  command('extract', '--quiet', labels, '--label', '1', '-o', stl);
  command('view', stl, '-o', path, '--no-open');
  await withPage({ path, viewport: small }, async (page) => {
    await rested(page);
    assert.ok(await page.isHidden('#labels'));
    await page.check('#measure');
    await page.focus('#view');
    await page.keyboard.press('Enter');
    const place = (await page.textContent('#distance')).match(/-?[\d.]+/g).map(Number);
    [[2, 12], [2, 13], [2, 13]].forEach(([low, high], axis) =>
      assert.ok(place[axis] >= low && place[axis] <= high, `${place}`));
    const { red: none, different } = await coloursOf(page);
    assert.equal(none, 0);
    await page.check('#cut');
    assert.notEqual((await coloursOf(page)).different, different);
    await openFiles(page, volume);
    await shownPolygons(page);
    assert.ok(await page.isVisible('#threshold'));
    await checkAccess(page);
  });
});

test('the page opens the meshes that it saves and that the command writes, and refuses damaged ones', onPage({ viewport: small }, async (page) => {
  await openFiles(page, volume);
  const own = join(folder, 'own.glb'), cut = join(folder, 'cut.glb');
  const glb = readFileSync((await saved(page, 'glb')).path);
  writeFileSync(own, glb);
  writeFileSync(cut, glb.subarray(0, glb.length - 100));
  await page.setInputFiles('#files', own);
  await page.waitForFunction(() => /triangles/.test(document.querySelector('#caption-merged').textContent));
  assert.ok(await page.isHidden('#smooth'), 'it has no normals');
  const { path: picture } = await saved(page, 'png');
  assert.equal(readFileSync(picture).subarray(1, 4).toString(), 'PNG');
  await checkAccess(page);
  await page.setInputFiles('#files', cut);
  await page.waitForSelector('#error:not([hidden])');
  assert.match(await page.textContent('#error-text'), /^cut.glb: an array ends beyond the file; save it again/);
  assert.match(await page.textContent('#file-name'), /^own.glb/);
}));
