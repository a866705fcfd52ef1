// check.js FOLDER [--external] [--without PATH...]: every link of the pages in a folder leads to a
// file there, and to an anchor in it. Addresses elsewhere must be well formed; --external asks for
// them, too. What lies in the paths of --without is taken to be there. Prints what is broken.
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { join, posix } from 'node:path';

const [folder, ...words] = process.argv.slice(2);
const isExternalAsked = words[0] === '--external';
const absent = words[0] === '--without' ? words.slice(1) : [];

const characters = { amp: '&', lt: '<', gt: '>', quot: '"', '#39': "'" };
const decoded = (text) =>
  decodeURIComponent(text.replace(/&(amp|lt|gt|quot|#39);/g, (_, name) => characters[name]));

/** The anchors and the links of a page; scripts are not looked into. */
function read(text) {
  const anchors = new Set();
  const links = [];
  const markup = text.replace(/<!--[^]*?-->|(<script\b[^>]*>)[^]*?<\/script>/gi, '$1');
  for (const [, tag, attributes] of markup.matchAll(/<([a-z][a-z0-9]*)\b([^>]*)>/gi))
    for (const [, name, value] of attributes.matchAll(/\s([a-z]+)="([^"]*)"/gi)) {
      if (name === 'id' || (name === 'name' && tag === 'a')) anchors.add(decoded(value));
      if (name === 'href' || name === 'src') links.push({ tag, href: decoded(value) });
    }
  return { anchors, links };
}

const pages = new Map();
for (const name of readdirSync(folder, { recursive: true }).map((path) => path.replaceAll('\\', '/')))
  if (name.endsWith('.html')) pages.set(name, read(readFileSync(join(folder, name), 'utf8')));

const asked = new Map();
/** What is wrong with an address elsewhere, or nothing. */
async function faultElsewhere(tag, href) {
  if (/^(data|blob|mailto):/.test(href)) return '';
  if (!URL.canParse(href)) return 'not an address';
  if (tag !== 'a') return 'asks the network';
  if (!isExternalAsked) return '';
  if (!asked.has(href)) {
    const answer = fetch(href, { signal: AbortSignal.timeout(30000) });
    asked.set(href, answer.then(({ ok, status }) => (ok ? '' : `answers ${status}`),
      ({ cause, message }) => cause?.message ?? message));
  }
  return asked.get(href);
}

/** What is wrong with a link of a page, or nothing. */
async function faultOf(page, { tag, href }) {
  if (/^[a-z]+:/i.test(href)) return faultElsewhere(tag, href);
  const [path, anchor] = href.split('#');
  let target = path ? posix.join(posix.dirname(page), path) : page;
  if (absent.some((place) => target === place || target.startsWith(`${place}/`))) return '';
  if (target.startsWith('..') || !existsSync(join(folder, target))) return 'no such file';
  if (statSync(join(folder, target)).isDirectory()) return 'a folder, which needs a server';
  return !anchor || pages.get(target)?.anchors.has(anchor) ? '' : 'no such anchor';
}

let count = 0;
let broken = 0;
for (const [page, { links }] of pages)
  for (const link of links) {
    ++count;
    const fault = await faultOf(page, link);
    if (fault) console.error(`${page}: ${link.href}: ${fault}`);
    if (fault) ++broken;
  }
console.log(`${pages.size} pages, ${count} links, ${broken} broken`);
process.exitCode = broken > 0 ? 1 : 0;
