// The page in Chromium, without a network.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';
import { inOrder } from './command.js';

const require = createRequire(new URL('../../../ports/web/', import.meta.url));
const { chromium } = require('playwright-core');

// Without a graphics card the browser copies every drawn picture, and warns about it.
const ofSoftware = /GPU stall due to ReadPixels/;

/** @returns {Promise<import('playwright-core').Browser>} */
export const startBrowser = () => chromium.launch({
  executablePath: process.env.DISCMC_CHROMIUM,
  args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', '--disable-gpu',
    '--enable-unsafe-swiftshader'],
});

/**
 * Opens the page from its file, or a server; `complaints` collects what it asks the network for
 * beyond that, and errors.
 * script: a function and its argument, which is called before the page's own.
 */
export async function openPage(browser,
  { path = process.env.DISCMC_PAGE, address, script, ...options } = {}) {
  const context = await browser.newContext({ offline: !address, viewport: { width: 1000, height: 700 },
    acceptDownloads: true, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(60000);
  const complaints = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !ofSoftware.test(message.text()))
      complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => {
    const isOwn = address && [address, `${address}data`].includes(request.url());
    if (!isOwn && !/^(file|blob|data):/.test(request.url()))
      complaints.push(`asked for ${request.url()}`);
  });
  await page.addInitScript(() => {
    globalThis.measured = [];
    new PerformanceObserver((list) => globalThis.measured.push(...list.getEntries()))
      .observe({ type: 'measure' });
  });
  if (script) await page.addInitScript(...script);
  await page.goto(address ?? pathToFileURL(path).href);
  await page.waitForSelector('body[data-ready]');
  return { page, complaints };
}

/** Starts a browser for the tests of a file. Their page, opened with options, must have no complaint. */
export function pageTests() {
  let browser;
  before(async () => (browser = await startBrowser()));
  after(() => browser.close());
  const withPage = async (options, check) => {
    const { page, complaints } = await openPage(browser, options);
    const result = await check(page);
    assert.deepEqual(complaints, []);
    await page.context().close();
    return result;
  };
  return { withPage, onPage: (options, check) => () => withPage(options, check) };
}

/** Opens files, and waits until their surface or an error is there. */
export async function openFiles(page, files) {
  await page.setInputFiles('#files', files);
  await page.waitForFunction(() => !document.querySelector('#error').hidden ||
    (document.querySelector('#busy').hidden && document.querySelector('#polygons').textContent !== '–'));
}

/** Waits until the surface of a threshold is shown. */
export const shown = (page, iso) => page.waitForFunction((wanted) =>
  globalThis.measured.some(({ name, detail }) => name === 'extracted' && detail.iso === wanted), iso);

/** Waits for a picture of final quality that was begun after a moment of now(). */
export const rested = (page, since = 0) => page.waitForFunction((begin) =>
  globalThis.measured.some(({ name, startTime, detail }) =>
    name === 'drawn' && detail.isFinal && startTime > begin), since);
export const now = (page) => page.evaluate(() => performance.now());

/** What the browser saves at a click. */
export async function saved(page, kind) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(`[data-save=${kind}]`)]);
  return { name: download.suggestedFilename(), path: await download.path() };
}

/** The polygons that are shown, as inOrder() has them. */
export const shownPolygons = async (page) =>
  inOrder(readFileSync((await saved(page, 'jsonl')).path, 'utf8'));

/** Waits until the text about a stream begins with these words. */
export const streamShows = (page, words) => page.waitForFunction((wanted) =>
  document.querySelector('#stream-text').textContent.startsWith(wanted), words);

/** Waits until a surface is shown. */
export const hasSurface = (page) => page.waitForFunction(() =>
  document.querySelector('#polygons').textContent !== '–');

/** The page as it is now has no fault that axe calls serious. */
export async function checkAccess(page) {
  await page.addScriptTag({ path: require.resolve('axe-core/axe.min.js') });
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  const serious = violations.filter(({ impact }) => ['serious', 'critical'].includes(impact));
  assert.deepEqual(serious.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), []);
}

/** The picture as the page saves it: its width; red, green, blue and opacity of each pixel. */
export async function pixelsOf(page) {
  const picture = readFileSync((await saved(page, 'png')).path).toString('base64');
  const { pixels, width } = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const pixels = Array.from({ length: data.length / 32768 + 1 }, (_, i) =>
      String.fromCharCode(...data.subarray(32768 * i, 32768 * (i + 1)))).join('');
    return { pixels: btoa(pixels), width: image.width };
  }, picture);
  return Object.assign(Buffer.from(pixels, 'base64'), { width });
}
