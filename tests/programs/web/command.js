// The command, for comparison with the page: both must make the same of a volume.
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** A folder for the files of a test; gone at its end. */
export function workFolder(after) {
  const folder = mkdtempSync(join(tmpdir(), 'discmc-web-'));
  after(() => rmSync(folder, { recursive: true }));
  return folder;
}

export const command = (...words) =>
  execFileSync(process.env.DISCMC_COMMAND, words, { stdio: ['ignore', 'pipe', 'pipe'] });

/** `discmc view --serve`, as servedBy() has it. */
export const served = (context, ...words) =>
  servedBy(context, process.env.DISCMC_COMMAND, 'view', ...words, '--serve', '--no-open');

/**
 * A program that serves the page, once it does: its address, its standard input, and end(). The latter
 * ends it as Ctrl-C does, and returns its exit code. context: of the test, at whose end it is gone.
 */
export async function servedBy(context, program, ...words) {
  const server = spawn(program, words, { stdio: ['pipe', 'pipe', 'inherit'], detached: true });
  const ended = new Promise((resolve) => server.on('exit', resolve));
  const signal = (name) => process.kill(-server.pid, name); // to all that it has started, too
  context.after(() => server.exitCode ?? signal('SIGKILL'));
  const told = await new Promise((resolve) => {
    server.stdout.once('data', (text) => resolve(`${text}`));
    ended.then((code) => resolve(`it has ended with ${code}`));
  });
  const end = () => signal('SIGINT') && ended;
  const address = told.match(/http:\S+/)?.[0];
  if (!address) throw new Error(told);
  return { address, input: server.stdin, end };
}

/** The polygons of a volume or stream, as inOrder() has them. */
export function polygonsByCommand(folder, ...words) {
  const file = join(folder, 'polygons.jsonl');
  command(...words, '-o', file);
  return inOrder(readFileSync(file, 'utf8'));
}

/** Polygons, a line each, in an order that does not depend on how they were joined. */
export const inOrder = (lines) => lines.split('\n').filter(Boolean).map((line) => {
  const polygon = JSON.parse(line);
  const [outer, ...holes] = polygon.rings.map(fromFirstCorner);
  return JSON.stringify({ ...polygon, rings: [outer, ...holes.sort()] });
}).sort().join('\n');

function fromFirstCorner(ring) {
  const corners = ring.map(String);
  const first = corners.indexOf(corners.reduce((a, b) => (b < a ? b : a)));
  return [...ring.slice(first), ...ring.slice(0, first)];
}
