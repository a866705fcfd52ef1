// The page in a browser: actions of a user, and their results.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { facing } from '../../../ports/web/page/facing.js';
import { planesOf } from '../../../ports/web/page/light.js';
import { nrrdOf, roughBall } from './ball.js';
import { checkAccess, hasSurface, now, openFiles, pageTests, pixelsOf, rested, saved, shown, shownPolygons,
  streamShows } from './browser.js';
import { command, inOrder, polygonsByCommand, workFolder } from './command.js';

const folder = workFolder(after);
const volume = join(folder, 'ball.nrrd');
writeFileSync(volume, nrrdOf(roughBall()));
const byCommand = (iso) => polygonsByCommand(folder, 'extract', '--quiet', volume, '--iso', `${iso}`);

const small = { width: 800, height: 400 }; // for many pictures

const { withPage, onPage } = pageTests();

const setThreshold = (page, iso) => page.evaluate((value) => {
  const slider = document.querySelector('#threshold');
  slider.value = value;
  slider.dispatchEvent(new Event('input', { bubbles: true }));
}, iso);

test('while 40 thresholds are dragged over, each surface equals that of the command', onPage({}, async (page) => {
  await openFiles(page, volume);
  for (let step = 0; step < 40; ++step) {
    const iso = -100 + 25 * step;
    await setThreshold(page, iso);
    await shown(page, iso);
    assert.equal(await shownPolygons(page), byCommand(iso), `threshold ${iso}`);
  }
}));

test('a file that is dropped on the page is opened', onPage({}, async (page) => {
  await page.evaluate((base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([bytes], 'dropped.nrrd'));
    for (const kind of ['dragenter', 'dragover', 'drop'])
      document.querySelector('#view').dispatchEvent(
        new DragEvent(kind, { bubbles: true, cancelable: true, dataTransfer }));
  }, readFileSync(volume).toString('base64'));
  await page.waitForFunction(() => globalThis.measured.some(({ name }) => name === 'drawn' &&
    document.querySelector('#polygons').textContent !== '–'));
  assert.match(await page.textContent('#file-name'), /^dropped.nrrd · 48 × 40 × 36 voxels/);
}));

test('every format is read in a browser', onPage({}, async (page) => {
  const volumes = new URL('../../command/volumes/', import.meta.url).pathname;
  for (const file of ['nrrd/i16-big-gzip.nrrd', 'nifti1/i16-little.nii.gz', 'nifti2/f32-big.nii',
    'metaimage/i16-little-compressed.mha', 'numpy/i16-big.npy', 'dicom/u16.dcm']) {
    await openFiles(page, join(volumes, file));
    assert.ok(await page.isHidden('#error'), await page.textContent('#error-text'));
    assert.match(await page.textContent('#file-name'), /^.+ · \d+ × \d+ × \d+ voxels/);
  }
}));

test('after a fast drag the last threshold is shown', onPage({}, async (page) => {
  await openFiles(page, volume);
  for (let iso = 100; iso <= 500; iso += 4) await setThreshold(page, iso);
  await shown(page, 500);
  const { name, path } = await saved(page, 'jsonl');
  assert.equal(name, 'ball-500.jsonl');
  assert.equal(inOrder(readFileSync(path, 'utf8')), byCommand(500));
}));

test('wrong, damaged and huge files are refused, and the page continues', onPage({}, async (page) => {
  const stream = join(folder, 'ball.dmc');
  command('extract', '--quiet', volume, '--iso', '400', '-o', stream);
  const damaged = join(folder, 'damaged.dmc');
  writeFileSync(damaged, readFileSync(stream).fill(0x55, 900, 1300));
  const wrong = join(folder, 'wrong.dmc');
  writeFileSync(wrong, 'this is a letter');
  const text = join(folder, 'letter.txt');
  writeFileSync(text, 'this is a letter');
  const huge = join(folder, 'huge.nrrd');
  writeFileSync(huge, nrrdOf({ dims: [9999, 9999, 9999], spacing: [1, 1, 1], samples: new Int16Array(4) }));
  const cut = join(folder, 'cut.nrrd');
  writeFileSync(cut, readFileSync(volume).subarray(0, 9000));

  const expected = [[wrong, /^wrong.dmc: there is no header .*; check/],
    [text, /^letter.txt: the format is unknown; open NRRD/],
    [huge, /^huge.nrrd: 9999 x 9999 x 9999 voxels .*; make/], [cut, /^cut.nrrd: the file ends after .*; check/]];
  for (const [file, message] of expected) {
    await openFiles(page, file);
    assert.match(await page.textContent('#error[role=alert] p'), message);
  }
  await openFiles(page, volume);
  assert.ok(await page.isHidden('#error'), 'the next file takes the message away');

  await openFiles(page, cut);
  await setThreshold(page, 425);
  await shown(page, 425);
  assert.equal(await shownPolygons(page), byCommand(425), 'what was open before still is');

  await openFiles(page, damaged);
  assert.match(await page.textContent('#stream-text'), /^Incomplete: [1-9]\d* packets? and [1-9]\d* regions or fragments lost/);
  await openFiles(page, stream);
  await streamShows(page, 'Complete');
}));

test('a threshold given for a volume is dropped when a stream is opened meanwhile', onPage({}, async (page) => {
  const stream = join(folder, 'after.dmc');
  command('extract', '--quiet', volume, '--iso', '400', '-o', stream);
  await openFiles(page, volume);
  await page.check('#classic');
  await page.evaluate(() => { // the slider moves while the stream is read
    const slider = document.querySelector('#threshold');
    let value = 100;
    globalThis.drag = setInterval(() => {
      slider.value = value = 100 + ((value + 37) % 500);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    }, 5);
  });
  await page.setInputFiles('#files', stream);
  await streamShows(page, 'Complete');
  await page.waitForTimeout(600); // longer than updates that need not follow a slider at once
  await page.evaluate(() => clearInterval(globalThis.drag));
  assert.ok(await page.isHidden('#error'), await page.textContent('#error-text'));
  assert.ok(await page.isHidden('#caption-classic'), 'no Marching Cubes of the volume beside the stream');
  const { path } = await saved(page, 'dmc');
  assert.deepEqual(readFileSync(path), readFileSync(stream));
}));

test('if a volume and a stream are opened at once, the last is shown and saved', onPage({}, async (page) => {
  const stream = join(folder, 'first.dmc');
  command('extract', '--quiet', volume, '--iso', '400', '-o', stream);
  await page.setInputFiles('#files', stream);
  await page.setInputFiles('#files', volume);
  await page.waitForFunction(() => /bytes/.test(document.querySelector('#device-regions').textContent));
  assert.equal((await saved(page, 'dmc')).name.replace(/-[-\d.]+dmc$/, ''), 'ball');
  await page.setInputFiles('#files', volume);
  await page.setInputFiles('#files', stream);
  await page.waitForFunction(() => /^first/.test(document.querySelector('#file-name').textContent));
  await page.waitForTimeout(600);
  assert.ok(await page.isHidden('#error'), await page.textContent('#error-text'));
  const { path } = await saved(page, 'dmc');
  assert.deepEqual(readFileSync(path), readFileSync(stream));
}));

test('the view is the same after a lost WebGL context is restored', onPage({}, async (page) => {
  await openFiles(page, volume);
  await page.check('#edges');
  await page.check('#classic');
  await page.waitForSelector('#caption-classic:not([hidden])');
  await rested(page, await now(page));
  const picture = () => page.locator('#view').screenshot();
  const before = await picture();
  await page.evaluate(() => {
    const card = document.querySelector('#view').getContext('webgl2').getExtension('WEBGL_lose_context');
    card.loseContext();
    setTimeout(() => card.restoreContext(), 300);
  });
  await page.waitForTimeout(300);
  await rested(page, await now(page));
  assert.ok(before.equals(await picture()));
}));

test('a stream too wide to draw is refused with a remedy', onPage({}, async (page) => {
  const raw = join(folder, 'wide.raw'), path = join(folder, 'wide.dmc');
  writeFileSync(raw, Buffer.alloc(20000 * 2 * 2, 1));
  command('extract', raw, '--dims', '20000,2,2', '--type', 'u8', '--iso', '1', '-o', path, '--quiet');
  await openFiles(page, path);
  assert.match(await page.textContent('#error'), /20000 x 2 x 2 voxels; the page accepts at most 16383 .*--crop/);
}));

test('each surface of a stream with several can be chosen', onPage({}, async (page) => {
  const path = join(folder, 'several.dmc');
  command('extract', volume, '--iso', '200', '--iso', '600', '--scan', '7', '-o', path, '--quiet');
  await openFiles(page, path);
  assert.deepEqual(await page.locator('#surface option').allTextContents(),
    ['scan 7, channel 0, threshold 200', 'scan 7, channel 1, threshold 600']);
  for (const channel of [1, 0]) {
    await page.selectOption('#surface', { index: channel });
    await page.waitForFunction((iso) => document.querySelector('#stream-text').textContent
      .endsWith(`threshold ${iso}.`), channel ? 600 : 200);
    assert.equal(await page.evaluate(() => document.querySelector('#surface').selectedIndex), channel);
    assert.equal(await shownPolygons(page),
      polygonsByCommand(folder, 'decode', path, '--stream-channel', `${channel}`));
  }
  await openFiles(page, volume);
}));

test('keys alone suffice: open, threshold, look around, measure, save', onPage({}, async (page) => {
  const focus = async (selector) => {
    for (let tabs = 0; tabs < 60; ++tabs) {
      if (await page.evaluate((wanted) => document.activeElement?.matches(wanted), selector)) return;
      await page.keyboard.press('Tab');
    }
    assert.fail(`no way to ${selector} by Tab`);
  };
  page.on('filechooser', () => {}); // from now on the browser transfers the buffer
  await focus('#open');
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.keyboard.press('Enter')]);
  await chooser.setFiles(volume);
  await hasSurface(page);
  const first = Number(await page.inputValue('#threshold'));
  await focus('#threshold');
  for (let press = 0; press < 5; ++press) await page.keyboard.press('ArrowRight');
  await shown(page, first + 5);
  await focus('#edges');
  await page.keyboard.press('Space');
  await focus('#measure');
  await page.keyboard.press('Space');
  await focus('#view');
  const picture = () => page.screenshot({ clip: { x: 0, y: 100, width: 900, height: 600 } });
  await rested(page);
  const before = await picture();
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /^From .* mm to/.test(document.querySelector('#distance').textContent));
  const begin = await now(page);
  for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowUp', 'Shift+ArrowLeft', '+']) await page.keyboard.press(key);
  await rested(page, begin);
  assert.ok(!before.equals(await picture()), 'the view has turned');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /^[\d.]+ mm$/.test(document.querySelector('#distance').textContent));
  const distance = parseFloat(await page.textContent('#distance'));
  assert.ok(distance > 0.2 && distance < 30, `${distance} mm on a ball of some 20`);
  await focus('[data-save=png]');
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
  assert.equal(readFileSync(await download.path()).subarray(1, 4).toString(), 'PNG');
}));

test('axe finds no serious violation: empty, with a volume, in the dark, on a small screen', async () => {
  for (const options of [{}, { colorScheme: 'dark' }, { viewport: { width: 390, height: 780 } }])
    await withPage(options, async (page) => {
      await checkAccess(page);
      await openFiles(page, volume);
      await checkAccess(page);
    });
});

test('every switch of the view works and reports no error', onPage({}, async (page) => {
  await openFiles(page, volume);
  for (const id of ['edges', 'smooth', 'classic', 'filter', 'cut']) await page.check(`#${id}`);
  await page.waitForSelector('#caption-classic:visible');
  for (const colouring of ['1', '2']) await page.selectOption('#colouring', colouring);
  for (const axis of ['0', '1']) await page.selectOption('#axis', axis);
  await page.waitForFunction(() => /bytes/.test(document.querySelector('#device-regions').textContent));
  await page.focus('#memory');
  await page.keyboard.press('Home');
  await page.waitForFunction(() => /joined/.test(document.querySelector('#device-fragments').textContent));
  const stream = await saved(page, 'dmc');
  assert.match(command('info', stream.path).toString(), /^threshold -?\d+$/m);
  for (const kind of ['stl', 'glb']) assert.ok(readFileSync((await saved(page, kind)).path).length > 10000);
}));

/** The mean colour of what is drawn. */
async function colourOf(page) {
  const data = await pixelsOf(page);
  const sums = [0, 0, 0, 0];
  for (let i = 0; i < data.length; i += 4)
    if (data[i + 3] > 0) sums.forEach((_, j) => (sums[j] += j < 3 ? data[i + j] : 1));
  return { red: sums[0] / sums[3], blue: sums[2] / sums[3], pixels: sums[3] };
}

test('a volume is shaded smoothly at first, and its polygons are flat by a click', onPage({ viewport: small }, async (page) => {
  await openFiles(page, volume);
  await setThreshold(page, 400);
  await shown(page, 400);
  const colours = async () => {
    const data = await pixelsOf(page);
    return new Set(Array.from({ length: data.length / 4 }, (_, i) => data.readUInt32BE(4 * i))).size;
  };
  const smooth = await colours();
  await page.evaluate(() => (globalThis.measured.length = 0));
  await page.uncheck('#smooth');
  await shown(page, 400);
  const flat = await colours();
  assert.ok(flat <= 28 && smooth > 10 * flat, `${flat} colours of planes, and ${smooth}`);
}));

test('the outside is seen, flat and smooth, also of a volume whose x runs backwards; a cut shows the inside', onPage({ viewport: small }, async (page) => {
  for (const side of [1, -1]) {
    const path = join(folder, 'side.nrrd');
    const ball = roughBall();
    writeFileSync(path, nrrdOf({ ...ball, spacing: [0.5 * side, 0.5, 0.5] }));
    await openFiles(page, path);
    for (const isSmooth of [false, true]) {
      await page.setChecked('#smooth', isSmooth);
      await setThreshold(page, 400 + (isSmooth ? 1 : 0));
      await shown(page, 400 + (isSmooth ? 1 : 0));
      const { red, blue, pixels } = await colourOf(page);
      assert.ok(pixels > 10000 && red > 1.2 * blue, `bone, not blue: ${red} and ${blue} of ${pixels}`);
    }
    await page.check('#cut');
    const cut = await colourOf(page);
    assert.ok(cut.red < 1.2 * cut.blue, `${cut.red} and ${cut.blue}`);
    await page.evaluate(() => (globalThis.measured.length = 0));
  }
}));

test('the slice follows the pointer on the surface, until one is chosen', onPage({}, async (page) => {
  await openFiles(page, volume);
  await rested(page);
  const place = () => page.evaluate(() => Number(document.querySelector('#place').value));
  const { x, y, width, height } = await page.locator('#view').boundingBox();
  const point = async (right, down) => {
    await page.mouse.move(x + right * width, y + down * height);
    await page.evaluate(() => new Promise((done) =>
      requestAnimationFrame(() => requestAnimationFrame(done))));
    return place();
  };
  const [upper, lower] = [await point(0.5, 0.3), await point(0.5, 0.7)];
  assert.ok(upper > lower + 5, `${upper} above ${lower}`);
  assert.equal(await point(0.01, 0.01), lower, 'beside the surface');
  await page.focus('#place');
  await page.keyboard.press('ArrowRight');
  assert.equal(await point(0.5, 0.3), lower + 1, 'a chosen one stays');
  await page.check('#follow');
  assert.equal(await point(0.5, 0.3), upper);
}));

test('a measurement disappears with its surface, and a cut does not follow the pointer', onPage({}, async (page) => {
  await openFiles(page, volume);
  await rested(page);
  await page.check('#measure');
  await page.focus('#view');
  await page.keyboard.press('Enter');
  assert.match(await page.textContent('#distance'), /^From/);
  await setThreshold(page, 431);
  await shown(page, 431);
  assert.match(await page.textContent('#distance'), /^Click/);
  await page.check('#cut');
  assert.ok(await page.isDisabled('#follow'));
  await page.uncheck('#cut');
  assert.ok(await page.isEnabled('#follow'));
}));

test('omitted planes face away at any position in space', () => {
  const planes = planesOf([0.5, -0.75, 2]);
  const ends = Uint32Array.from(planes, (_, incidence) => incidence + 1);
  const halves = [20, 30, 10];
  const corners = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) =>
    [x * halves[0], y * halves[1], z * halves[2]])));
  for (const eye of [[90, 5, 3], [-30, 40, 200], [0, -31, 0], [21, 0, -11], [1, 2, 3]]) {
    const isAsked = planes.map(() => false);
    for (const { begin, end } of facing(planes, ends, eye, halves)) isAsked.fill(true, begin, end);
    planes.forEach((plane, incidence) => {
      const isSeen = corners.some((corner) =>
        plane.reduce((sum, part, i) => sum + part * (eye[i] - corner[i]), 0) > 0);
      assert.equal(isAsked[incidence], isSeen, `incidence ${incidence} from ${eye}`);
    });
  }
});

test('faces that face away are not drawn, and nothing that is seen is missing, from all sides', onPage({ viewport: small }, async (page) => {
  await openFiles(page, volume);
  await page.evaluate(() => {
    const place = document.querySelector('#place');
    place.value = place.max;
  });
  const steps = 6;
  for (let step = 0; step < steps; ++step) {
    // With a cut beyond the surface everything is drawn, so a few edges of the far side show through.
    await page.uncheck('#cut');
    const picture = await pixelsOf(page);
    await page.check('#cut');
    const all = await pixelsOf(page);
    assert.equal(picture.length, all.length);
    let different = 0, drawn = 0;
    for (let i = 0; i < all.length; i += 4) {
      if (all[i + 3] > 0) ++drawn;
      if (Math.abs(all[i] - picture[i]) > 8 || all[i + 3] !== picture[i + 3]) ++different;
    }
    assert.ok(drawn > 10000 && different < 0.02 * drawn, `${different} of ${drawn} pixels differ`);
    await page.focus('#view');
    for (let i = 0; i < 9; ++i) await page.keyboard.press(step % 2 ? 'ArrowUp' : 'ArrowLeft');
  }
}));

/** How many pixels wide and high the thing in a picture is. */
async function extentOf(page) {
  const data = await pixelsOf(page);
  const { width } = data;
  const columns = new Set(), rows = new Set();
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] === 0) continue;
    columns.add((i / 4) % width);
    rows.add(Math.floor(i / 4 / width));
  }
  return { wide: columns.size, high: rows.size };
}

test('a head is upright for any direction of its slices', onPage({ viewport: small }, async (page) => {
  const samples = new Int16Array(12 * 12 * 12).fill(0);
  // A rod along the voxels' x, y or z, which the header maps to the direction of the head.
  for (const axis of [0, 1, 2]) {
    samples.forEach((_, i) => {
      const at = [i % 12, Math.floor(i / 12) % 12, Math.floor(i / 144)];
      samples[i] = at.every((place, j) => (j === axis ? place > 0 : place > 4) && place < (j === axis ? 11 : 7))
        ? 100 : 0;
    });
    const directions = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]; // of x where the rod is along x, and so on
    const told = [0, 1, 2].map((j) => `(${directions[(j - axis + 3) % 3]})`).join(' ');
    const path = join(folder, 'rod.nrrd');
    const file = nrrdOf({ dims: [12, 12, 12], spacing: [1, 1, 1], samples }).toString('latin1')
      .replace(/spacings: .*\n/, `space: left-posterior-superior\nspace directions: ${told}\n`);
    writeFileSync(path, file, 'latin1');
    await openFiles(page, path);
    await setThreshold(page, 50 + axis);
    await shown(page, 50 + axis);
    const { wide, high } = await extentOf(page);
    assert.ok(high > 2 * wide, `along ${'xyz'[axis]}: ${wide} x ${high}`);
  }
}));

test('a page with data inside opens it at once', async () => {
  const path = join(folder, 'with_data.html');
  const data = deflateSync(readFileSync(volume)).toString('base64');
  const element = `<script type="application/base64" id="data" data-name="inside.nrrd" ` +
    `data-encoding="deflate" data-iso="425">${data}</script>`;
  const html = readFileSync(process.env.DISCMC_PAGE, 'utf8');
  writeFileSync(path, html.replace('<script type="application/base64" id="module">', (own) => element + own));
  await withPage({ path }, async (page) => {
    await shown(page, 425);
    assert.match(await page.textContent('#file-name'), /^inside.nrrd/);
  });
});

test('a threshold that no voxel reaches is reported', onPage({}, async (page) => {
  await openFiles(page, volume);
  await page.fill('#threshold-number', '99999');
  await page.keyboard.press('Enter');
  await shown(page, 99999);
  assert.equal(await page.textContent('#caption-merged'), 'No surface at this threshold');
}));

test('on a phone, messages are visible at any scroll position', onPage({ viewport: { width: 390, height: 844 } }, async (page) => {
  await openFiles(page, volume);
  await page.locator('#save-head').scrollIntoViewIfNeeded();
  const letter = join(folder, 'scrolled.txt');
  writeFileSync(letter, 'this is a letter');
  await openFiles(page, letter);
  const { y } = await page.locator('#error').boundingBox();
  assert.ok(y >= 0, `${y} pixels from the top`);
}));
