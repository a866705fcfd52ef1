// Streams shown while they arrive.
import assert from 'node:assert/strict';
import { copyFileSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { nrrdOf, roughBall } from './ball.js';
import { checkAccess, now, openFiles, pageTests, pixelsOf, rested, saved, shownPolygons,
  streamShows } from './browser.js';
import { command, polygonsByCommand, workFolder } from './command.js';

const folder = workFolder(after);
const volume = join(folder, 'ball.nrrd'), stream = join(folder, 'ball.dmc');
writeFileSync(volume, nrrdOf(roughBall()));
command('extract', '--quiet', volume, '--iso', '400', '-o', stream);
const expected = polygonsByCommand(folder, 'decode', stream);

const { onPage } = pageTests();

/** How many pixels of the picture are of the colour of what is missing. */
async function vermilion(page) {
  const pixels = await pixelsOf(page);
  let count = 0;
  for (let i = 0; i < pixels.length; i += 4)
    if (pixels[i] === 0xd5 && pixels[i + 1] === 0x5e && pixels[i + 2] === 0) ++count;
  return count;
}
const count = async (page) => Number((await page.textContent('#polygons')).replace(',', ''));

test('a stream is replayed at the pace of its link, and is the same in the end', onPage({}, async (page) => {
  await openFiles(page, stream);
  const all = await count(page);
  await page.selectOption('#replay-baud', '115200');
  await page.click('#replay');
  await streamShows(page, 'Arriving');
  const early = await count(page);
  assert.ok(early < all, `${early} of ${all} polygons at the beginning`);
  const seconds = (readFileSync(stream).length * 10) / 115200;
  const begin = Date.now();
  await streamShows(page, 'Complete');
  assert.ok(Date.now() - begin > (seconds / 2) * 1000, 'as slow as the link');
  assert.equal(await shownPolygons(page), expected);
  await page.check('#measure');
  await page.press('#view', 'Enter');
  assert.match(await page.textContent('#distance'), /^From/, 'the surface is in the picture');
}));

test('a stream with fractions is interpolated while it arrives; other shapes can be chosen', onPage({}, async (page) => {
  const [fractions, expected, shown] =
    ['fractions.dmc', 'expected.stl', 'shown.stl'].map((name) => join(folder, name));
  command('extract', '--quiet', volume, '--iso', '400', '--wire', 'slices', '--levels', '4', '-o', fractions);
  await openFiles(page, fractions);
  const caption = () => page.textContent('#caption-merged');
  const all = await caption();
  await page.selectOption('#replay-baud', '9600');
  await page.click('#replay');
  await streamShows(page, 'Arriving');
  assert.match(await caption(), /triangles, interpolated$/);
  assert.notEqual(await caption(), all);
  await streamShows(page, 'Complete');
  assert.equal(await caption(), all);
  for (const shape of ['interpolated', 'relaxed']) {
    await page.selectOption('#shape', shape);
    await page.waitForFunction((wanted) =>
      document.querySelector('#caption-merged').textContent.endsWith(wanted), shape);
    await rested(page, await now(page));
    command('decode', fractions, '--surface', shape, '-o', expected);
    copyFileSync((await saved(page, 'stl')).path, shown);
    const told = command('compare', expected, shown).toString();
    assert.match(told, /A to B, mm +0.0000 +0.0000 +0.0000\n.*B to A, mm +0.0000 +0.0000 +0.0000/);
  }
  await page.check('#measure');
  await page.press('#view', 'Enter');
  assert.match(await page.textContent('#distance'), /^From/, 'the surface is in the picture');
  await checkAccess(page);
  await page.selectOption('#shape', 'polygons');
  await page.waitForFunction(() => /merged polygons/.test(document.querySelector('#caption-merged').textContent));
  await openFiles(page, stream);
  assert.equal(await page.inputValue('#shape'), 'polygons');
  assert.ok(await page.isDisabled('#shape-interpolated'), 'it has no fractions');
}));

test('lost packets are reported, and whole regions are shown', onPage({}, async (page) => {
  await openFiles(page, stream);
  await page.evaluate(() => {
    let call = 0;
    Math.random = () => (++call % 5 === 0 ? 0 : 1); // every fifth packet
  });
  await page.selectOption('#replay-baud', '3000000');
  await page.selectOption('#replay-lost', '0.2');
  await page.click('#replay');
  await streamShows(page, 'Incomplete');
  assert.match(await page.textContent('#stream-text'), /\d+ packets? and \d+ regions or fragments lost/);
  const whole = new Set(expected.split('\n'));
  const shown = (await shownPolygons(page)).split('\n');
  assert.ok(shown.length > 0 && shown.length < whole.size);
  for (const polygon of shown) assert.ok(whole.has(polygon), polygon);
  assert.match(await page.textContent('#missing-text'), /^Missing in slices \d/);
  const outline = await vermilion(page);
  await page.uncheck('#missing');
  assert.ok(outline > 100, `${outline} pixels`);
  assert.equal(await vermilion(page), 0);
  await checkAccess(page);
  await openFiles(page, stream);
  assert.ok(await page.isHidden('#missing-row'), 'a whole stream has no missing parts');
}));

test('a replay can be stopped, and another file opened meanwhile', onPage({}, async (page) => {
  await openFiles(page, stream);
  await page.selectOption('#replay-baud', '9600');
  await page.click('#replay');
  await streamShows(page, 'Arriving');
  await page.click('#stop');
  await streamShows(page, 'Incomplete');
  await page.click('#replay');
  await streamShows(page, 'Arriving');
  await openFiles(page, volume);
  await page.waitForSelector('#threshold');
  assert.match(await page.textContent('#file-name'), /^ball.nrrd/);
  assert.ok(await page.isHidden('#stop'));
}));

/** A port that sends these bytes, and then is gone. */
const fakeSerial = (list) => {
  const readable = new ReadableStream({
    async start(controller) {
      for (let at = 0; at < list.length; at += 100) {
        controller.enqueue(new Uint8Array(list.slice(at, at + 100)));
        await new Promise((resolve) => setTimeout(resolve, 1));
      }
      controller.close();
    },
  });
  const port = { readable, open: async (options) => (port.options = options), close: async () => {} };
  Object.defineProperty(navigator, 'serial', { value: { port, requestPort: async () => port } });
};

const sending = (bytes) => ({ script: [fakeSerial, [...bytes]] });

test('the stream of a serial port is shown, and saved unchanged', onPage(sending(readFileSync(stream)), async (page) => {
  await page.click('#connect');
  await checkAccess(page);
  await page.fill('#serial-baud', '921600');
  await page.keyboard.press('Enter');
  await streamShows(page, 'Complete');
  assert.equal(await page.evaluate(() => navigator.serial.port.options.baudRate), 921600);
  assert.equal(await shownPolygons(page), expected);
  assert.deepEqual(readFileSync((await saved(page, 'dmc')).path), readFileSync(stream));
}));

test('bytes that are no stream are reported with the baud rate to check', onPage(sending(Buffer.from('no stream')), async (page) => {
  await page.click('#connect');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#error:not([hidden])');
  assert.match(await page.textContent('#error-text'), /no header .* check the baud rate/);
  await openFiles(page, stream);
  assert.equal(await shownPolygons(page), expected);
}));
