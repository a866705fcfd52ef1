// The parts of a damaged stream that are missing.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { nrrdOf, roughBall } from './ball.js';
import { command, workFolder } from './command.js';
import { startModule } from './module_of_page.js';

const folder = workFolder(after);
const volume = join(folder, 'ball.nrrd');
writeFileSync(volume, nrrdOf(roughBall()));

function framesOf(...options) {
  const file = join(folder, 'ball.dmc');
  command('extract', '--quiet', volume, '--iso', '400', ...options, '-o', file);
  const text = readFileSync(file).toString('latin1');
  return text.split(/(?<=\0)/).map((frame) => Buffer.from(frame, 'latin1'));
}

/** What is left, in a module, and what of it is missing. */
async function decoded(frames) {
  const module = await startModule();
  module.newStream();
  for (const frame of frames) module.pushStream(frame);
  const state = module.endStream();
  const { lines, slices } = module.missing(true);
  return { module, state, slices, lines: new Int16Array(lines.buffer) };
}

/** Polygons with their directed links: [x, y, z] to [x, y, z]. */
function linksOf(module) {
  const numbers = module.polygons();
  const links = [];
  for (let at = 0; at < numbers.length;) {
    const rings = numbers[at + 1];
    at += 2;
    for (let ring = 0; ring < rings; ++ring) {
      const count = numbers[at++];
      const corner = (i) => [...numbers.subarray(at + 3 * (i % count), at + 3 * (i % count) + 3)];
      for (let i = 0; i < count; ++i) links.push(...unitsOf(corner(i), corner(i + 1)));
      at += 3 * count;
    }
  }
  return links;
}

/** A straight side as the links that it is made of. */
function unitsOf(from, to) {
  const way = to.map((at, i) => at - from[i]);
  const isAxial = way.filter((part) => part !== 0).length === 1;
  const count = Math.max(...way.map(Math.abs)) / (isAxial ? 2 : 1);
  const at = (i) => from.map((start, axis) => start + (way[axis] * i) / count);
  return Array.from({ length: count }, (_, i) => [at(i), at(i + 1)]);
}

const undirected = ([from, to]) => [`${from}`, `${to}`].sort().join(' ');

test('a whole stream has no missing parts', async () => {
  for (const options of [[], ['--wire', 'slices'], ['--memory', '4K']]) {
    const { state, lines, slices } = await decoded(framesOf(...options));
    assert.ok(state.isComplete);
    assert.deepEqual([...lines], []);
    assert.deepEqual(slices, []);
  }
});

test('lost polygons are outlined by the sides that they shared with those that are left', async () => {
  const frames = framesOf();
  const whole = linksOf((await decoded(frames)).module).map(undirected);
  for (const lost of [2, frames.length >> 1]) {
    const { module, state, lines, slices } = await decoded(frames.filter((_, i) => i !== lost));
    assert.equal(state.lostPackets, 1);
    // By counting: a link that occurs once, but twice in the whole surface.
    const counts = new Map();
    for (const link of linksOf(module).map(undirected)) counts.set(link, (counts.get(link) ?? 0) + 1);
    const expected = [...counts].filter(([, count]) => count % 2 === 1).map(([link]) => link).sort();
    const shown = [];
    for (let at = 0; at < lines.length; at += 6)
      shown.push(...unitsOf([...lines.subarray(at, at + 3)], [...lines.subarray(at + 3, at + 6)]));
    assert.ok(expected.length > 0 && expected.every((link) => whole.includes(link)));
    assert.deepEqual(shown.map(undirected).sort(), expected);
    const heights = [...lines].filter((_, i) => i % 3 === 2);
    assert.equal(slices[0][0], Math.max(0, Math.floor(Math.min(...heights) / 2)));
    assert.equal(slices.at(-1)[1], Math.min(35, Math.ceil(Math.max(...heights) / 2)));
  }
});

test('lost rows are marked by a box', async () => {
  const frames = framesOf('--wire', 'slices', '--key-slices', '1');
  const { state, lines, slices } = await decoded(frames.filter((_, i) => i !== 5));
  assert.ok(state.lostPackets === 1 && state.isComplete === false);
  assert.equal(slices.length, 1);
  const [first, last] = slices[0];
  const along = (axis) => [...lines].filter((_, i) => i % 3 === axis);
  assert.equal(Math.min(...along(0)), -1);
  assert.equal(Math.max(...along(0)), 2 * 48 - 1);
  assert.equal(Math.min(...along(2)), 2 * first - 1);
  assert.equal(Math.max(...along(2)), 2 * last + 1);
});

test('a stream that breaks off is open where it ends', async () => {
  const frames = framesOf();
  const { state, slices } = await decoded(frames.slice(0, frames.length >> 1));
  assert.ok(!state.hasTrailer);
  assert.ok(slices.length > 0 && slices.at(-1)[1] < 35, `${slices}`);
});
