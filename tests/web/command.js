// The command beside the page: what one makes of a volume the other must make, too.
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
 * A program that serves the page, once it does: its address, its standard input, and end(), which
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

/** The polygons of a volume or stream, a line each, sorted. */
export function polygonsByCommand(folder, ...words) {
  const file = join(folder, 'polygons.jsonl');
  command(...words, '-o', file);
  return sorted(readFileSync(file, 'utf8'));
}

/** The same with every ring from its first corner in order on: those of joined pieces begin anywhere. */
export const turned = (lines) => sorted(lines.split('\n').filter(Boolean).map((line) => {
  const polygon = JSON.parse(line);
  polygon.rings = polygon.rings.map((ring) => {
    const corners = ring.map(String);
    const first = corners.indexOf(corners.reduce((a, b) => (b < a ? b : a)));
    return [...ring.slice(first), ...ring.slice(0, first)];
  });
  polygon.rings.sort();
  return JSON.stringify(polygon);
}).join('\n'));

export const sorted = (lines) => lines.split('\n').sort().join('\n');
