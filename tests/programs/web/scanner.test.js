// Firmware in QEMU with its stream served: scripts/tools/show-scanner.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { nrrdOf, roughBall } from './ball.js';
import { command, servedBy, workFolder } from './command.js';

const script = fileURLToPath(new URL('../../../scripts/tools/show-scanner', import.meta.url));
const build = dirname(process.env.DISCMC_COMMAND);

const folder = workFolder(after);
const volume = join(folder, 'ball.nrrd'), stream = join(folder, 'ball.dmc');
writeFileSync(volume, nrrdOf(roughBall()));
process.env.DISCMC_BUILD = build;
const mark = Buffer.from([0]); // a device that starts ends the frame that a reset has cut

/** What the firmware sends. */
async function sentBy(t, ...options) {
  const { address } = await servedBy(t, script, '--no-open', '--baud', '921600', ...options, volume, '400');
  return Buffer.from(await (await fetch(`${address}data`)).arrayBuffer());
}

test('the page receives the stream of the firmware, byte by byte', async (t) => {
  const sent = await sentBy(t);
  const memory = readFileSync(join(build, 'scanner/scan.hpp'), 'utf8').match(/arena_bytes = (\d+)/)[1];
  command('extract', '--quiet', volume, '--iso', '400', '--memory', memory, '-o', stream);
  assert.ok(sent.equals(Buffer.concat([mark, readFileSync(stream)])), `${sent.length} bytes came`);
});

test('with --levels 4 the page receives slices with fractions', async (t) => {
  const sent = await sentBy(t, '--levels', '4');
  command('extract', '--quiet', volume, '--iso', '400', '--wire', 'slices', '--levels', '4', '--key-slices', '16',
    '-o', stream);
  assert.ok(sent.equals(Buffer.concat([mark, readFileSync(stream)])), `${sent.length} bytes came`);
});
