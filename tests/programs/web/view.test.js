// Pages that the command writes with data inside.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { nrrdOf, roughBall } from './ball.js';
import { hasSurface, openPage, shownPolygons, startBrowser } from './browser.js';
import { command, polygonsByCommand, workFolder } from './command.js';

const folder = workFolder(after);
const volume = join(folder, 'ball.nrrd');
writeFileSync(volume, nrrdOf(roughBall()));
const path = join(folder, 'page.html');

let browser;
before(async () => (browser = await startBrowser()));
after(() => browser.close());

/** Opens the page that the command makes; returns what it says is open, and its polygons. */
async function viewed(...words) {
  command('view', ...words, '-o', path, '--no-open');
  const { page, complaints } = await openPage(browser, { path });
  await hasSurface(page);
  const opened = await page.textContent('#file-name');
  const isVolume = await page.isVisible('#threshold');
  const iso = isVolume ? Number(await page.inputValue('#threshold-number')) : undefined;
  const polygons = await shownPolygons(page);
  assert.deepEqual(complaints, []);
  await page.context().close();
  return { opened, iso, polygons };
}

test('the samples of a volume, with all thresholds', async () => {
  const { opened, iso, polygons } = await viewed(volume);
  assert.equal(opened, 'ball.nrrd · 48 × 40 × 36 voxels of 0.5 × 0.75 × 1.25 mm');
  assert.equal(polygons, polygonsByCommand(folder, 'extract', '--quiet', volume, '--iso', `${iso}`));
});

test('one threshold of it', async () => {
  const { opened, polygons } = await viewed(volume, '--iso', '400');
  assert.match(opened, /^ball.nrrd at 400.dmc · 48 × 40 × 36 voxels/);
  assert.equal(polygons, polygonsByCommand(folder, 'extract', '--quiet', volume, '--iso', '400'));
});

test('a stream', async () => {
  const stream = join(folder, 'ball.dmc');
  command('extract', '--quiet', volume, '--iso', '400', '-o', stream);
  const { opened, polygons } = await viewed(stream);
  assert.match(opened, /^ball.dmc · /);
  assert.equal(polygons, polygonsByCommand(folder, 'decode', stream));
});
