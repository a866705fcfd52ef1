// The page and its data from a server: discmc view --serve.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createWriteStream, readFileSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { connect } from 'node:net';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { nrrdOf, roughBall } from './ball.js';
import { hasSurface, openPage, saved, shownPolygons, startBrowser, streamShows } from './browser.js';
import { command, polygonsByCommand, served, workFolder } from './command.js';

const folder = workFolder(after);
const volume = join(folder, 'ball.nrrd'), stream = join(folder, 'ball.dmc');
writeFileSync(volume, nrrdOf(roughBall()));
command('extract', '--quiet', volume, '--iso', '400', '-o', stream);
const bytes = readFileSync(stream), half = bytes.length >> 1;
const expected = polygonsByCommand(folder, 'decode', stream);

let browser;
before(async () => (browser = await startBrowser()));
after(() => browser.close());

test('a volume is fetched, and any threshold can be chosen', async (t) => {
  const { address, end } = await served(t, volume);
  const { page, complaints } = await openPage(browser, { address });
  await hasSurface(page);
  assert.equal(await page.textContent('#file-name'),
    'ball.nrrd · 48 × 40 × 36 voxels of 0.5 × 0.75 × 1.25 mm');
  const iso = await page.inputValue('#threshold-number');
  assert.equal(await shownPolygons(page),
    polygonsByCommand(folder, 'extract', '--quiet', volume, '--iso', iso));
  assert.deepEqual(complaints, []);
  await page.context().close();
  assert.equal(await end(), 0);
});

test('a surface at a threshold and a stream file are served whole', async (t) => {
  for (const words of [[volume, '--iso', '400'], [stream]]) {
    const { address, end } = await served(t, ...words);
    const { page, complaints } = await openPage(browser, { address });
    await streamShows(page, 'Complete');
    assert.equal(await shownPolygons(page), expected);
    assert.deepEqual(complaints, []);
    await page.context().close();
    assert.equal(await end(), 0);
  }
});

test('labels are served as meshes', async (t) => {
  const { address, end } = await served(t, volume, '--labels', '400');
  const { page, complaints } = await openPage(browser, { address });
  await page.waitForFunction(() => /triangles/.test(document.querySelector('#caption-merged').textContent));
  assert.equal(await page.textContent('#labels'), '400');
  assert.deepEqual(complaints, []);
  await page.context().close();
  assert.equal(await end(), 0);
});

test('a stream on standard input is shown as it arrives; later clients get all of it', async (t) => {
  const { address, input, end } = await served(t, '-');
  input.write(bytes.subarray(0, half));
  const first = await openPage(browser, { address });
  await streamShows(first.page, 'Arriving');
  const early = Number((await first.page.textContent('#polygons')).replace(',', ''));
  assert.ok(early > 0 && early < expected.split('\n').length, `${early} polygons of the first half`);
  const later = await openPage(browser, { address });
  await streamShows(later.page, 'Arriving');
  input.end(bytes.subarray(half));
  for (const { page, complaints } of [first, later]) {
    await streamShows(page, 'Complete');
    assert.equal(await shownPolygons(page), expected);
    assert.deepEqual(readFileSync((await saved(page, 'dmc')).path), bytes);
    assert.deepEqual(complaints, []);
    await page.context().close();
  }
  assert.equal(await end(), 0);
});

test('a named pipe is served once it has a writer, and a truncated stream is reported', async (t) => {
  const pipe = join(folder, 'pipe');
  execFileSync('mkfifo', [pipe]);
  const { address, end } = await served(t, pipe);
  const { page } = await openPage(browser, { address });
  assert.equal(await page.textContent('#busy'), 'Waiting for the stream…');
  createWriteStream(pipe).write(bytes.subarray(0, half));
  await streamShows(page, 'Arriving');
  assert.ok(await page.isHidden('#busy'));
  assert.equal(await end(), 0, 'while the page listens');
  await streamShows(page, 'Incomplete');
  await page.context().close();
});

/** What the server answers. */
const answer = (address, path, { method = 'GET', ...headers }) => new Promise((resolve, reject) => {
  const { hostname, port } = new URL(address);
  const asked = request({ hostname, port, path, method, headers }, (response) => {
    response.resume();
    response.on('end', () => resolve(response));
  });
  asked.on('error', reject);
  asked.end();
});

test('other names, methods, parts and paths are refused', async (t) => {
  const { address, end } = await served(t, stream);
  const { host, port } = new URL(address);
  const status = async (path, options) => (await answer(address, path, options)).statusCode;
  for (const name of [host, `localhost:${port}`, 'localhost'])
    assert.equal(await status('/data', { Host: name }), 200, name);
  for (const name of [`evil.example:${port}`, 'evil.example', '127.0.0.1.evil.example', ':'])
    assert.equal(await status('/data', { Host: name }), 403, name);
  for (const method of ['HEAD', 'POST', 'PUT', 'DELETE', 'OPTIONS'])
    assert.equal(await status('/data', { Host: host, method }), 405, method);
  for (const path of ['/data/', '/../ball.nrrd', `${stream}`, '//', '/data%00', '/index.html'])
    assert.equal(await status(path, { Host: host }), 404, path);
  assert.equal(await status('/data', { Host: host, Range: 'bytes=1-2' }), 416);
  const { headers } = await answer(address, '/data', { Host: host });
  assert.equal(headers['x-content-type-options'], 'nosniff');
  assert.equal(headers['access-control-allow-origin'], undefined);
  assert.equal(Number(headers['content-length']), bytes.length);
  assert.equal(await end(), 0);
});

/** Sends pieces one after the other until the server closes or there are no more; returns how many were sent. */
const sendAll = (address, first, pieces) => new Promise((resolve) => {
  const { hostname, port } = new URL(address);
  const client = connect(Number(port), hostname).on('error', () => {}).on('close', () => resolve(sent));
  let sent = 0;
  client.resume();
  client.write(first, function next(error) {
    if (error) return; // 'close' follows
    if (sent === pieces.length) client.destroy();
    else client.write(pieces[sent++], next);
  });
});

test('endless headers close their connection, and other clients are served meanwhile', async (t) => {
  const { address, end } = await served(t, stream);
  const { host } = new URL(address);
  const mebibyte = `X: ${'a'.repeat(4091)}\r\n`.repeat(256), endless = Array(64).fill(mebibyte);
  for (const first of [`GET / HTTP/1.1\r\nHost: ${host}\r\n`, 'GET /'])
    for (const sent of await Promise.all(Array.from({ length: 4 }, () => sendAll(address, first, endless))))
      assert.ok(sent < 32, `closed after ${sent} MiB`);
  assert.equal((await answer(address, '/data', { Host: host })).statusCode, 200);
  assert.equal(await end(), 0);
});

test('a slow client does not delay others', async (t) => {
  const large = join(folder, 'large.raw'); // more than a socket holds
  writeFileSync(large, Buffer.alloc(256 * 256 * 256));
  const { address, end } = await served(t, large, '--dims', '256,256,256', '--type', 'u8');
  const { port } = new URL(address);
  const slow = connect(Number(port), '127.0.0.1');
  slow.pause();
  slow.write(`GET /data HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\n\r\n`);
  await new Promise((resolve) => setTimeout(resolve, 300)); // it has begun
  const answer = await fetch(new URL('data', address), { signal: AbortSignal.timeout(10000) });
  assert.ok((await answer.arrayBuffer()).byteLength > 256 ** 3);
  slow.destroy();
  assert.equal(await end(), 0);
});

test('a client that sends only a part of a request does not hold up the end', async (t) => {
  const { address, end } = await served(t, stream);
  const { hostname, port } = new URL(address);
  const client = connect(port, hostname).on('error', () => {});
  await new Promise((resolve) => client.write('GET /da', resolve));
  await answer(address, '/', { Host: hostname }); // the part has come, too
  const begin = performance.now();
  assert.equal(await end(), 0);
  assert.ok(performance.now() - begin < 3000);
  client.destroy();
});
