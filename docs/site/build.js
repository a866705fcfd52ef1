// build.js FOLDER FRAME: writes the guide as a site into FOLDER, and the head and the foot of the pages of the
// reference into FRAME. Begins with README.md and docs/README.md, and makes a page of every file of the repository that
// a link leads to. A page has the prose of a Markdown file, the README.md or contents of a folder, or the text of a
// source.
import {
  copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync,
} from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import { linksOf, pageOf } from './markdown.js';

const root = fileURLToPath(new URL('../..', import.meta.url));
const read = (path) => readFileSync(join(root, path), 'utf8');
const isExternal = (href) => /^[a-z]+:/i.test(href);
const isPicture = (path) => /\.(png|svg)$/.test(path);
const isReference = (path) => /^lib\/discmc\/[a-z_]+\.hp{0,2}$/.test(path);
const escaped = (text) => text.replace(/[&<>]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[c]);

/** A folder's page is that of its README.md. */
const readmeOf = (path) => (existsSync(join(root, path, 'README.md')) ? posix.join(path, 'README.md') : path);

/** Where the page of a file of the repository is in the site. */
function placeOf(path) {
  if (isPicture(path)) return path;
  if (isReference(path))
    return `api/${posix.basename(path).replaceAll('_', '__').replace('.', '_8')}.html`;
  if (statSync(join(root, path)).isDirectory()) return posix.join(path, 'index.html');
  if (posix.basename(path) === 'README.md') return posix.join(posix.dirname(path), 'index.html');
  return path.endsWith('.md') ? path.replace(/\.md$/, '.html') : `${path}.html`;
}

/** What the menu leads to: the entries of the guide's index. */
const entries = read('docs/README.md').split('\n').filter((line) => line.startsWith('- ['));
const guide = linksOf(entries.join('\n')).filter(({ href }) => !isExternal(href))
  .map(({ href, text }) => ({ place: placeOf(readmeOf(posix.join('docs', href))), text }));
const menu = [{ place: 'index.html', text: 'Overview' }, { place: 'docs/index.html', text: 'Guide' },
  ...guide, { place: 'api/files.html', text: 'Reference' }];
const top = [{ place: 'discmc.html', text: 'Live page' }, { place: 'docs/index.html', text: 'Guide' },
  { place: 'api/files.html', text: 'Reference' }];

/** The beginning of a page; up leads from its folder to that of the site. */
const headOf = (title, up, more = '') => `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>${title}</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="${up}style.css">
</head>
<body>
<header><a class="home" href="${up}index.html">discmc</a>${
  top.map(({ place, text }) => `<a href="${up}${place}">${text}</a>`).join('')}${more}</header>
`;
const foot = '</body>\n</html>\n';

const itemOf = (href, text, attribute = '', more = '') =>
  `<li${attribute}><a href="${href}">${escaped(text)}</a>${more}</li>`;

/** The calculator, where a page has a place for it. Inside the page, as it has to work from a file. */
const withCalculator = (body) => body.replace('<!-- calculator -->', () =>
  `${read('docs/site/calculator.html')}<script>\n${read('docs/site/calculator.js')}</script>`);

function htmlOf(place, { title, headings, body }) {
  const up = '../'.repeat(place.split('/').length - 1);
  const items = menu.map((entry) => {
    const here = entry.place === place;
    const sections = here && headings.length > 1
      ? `<ul>${headings.map(({ anchor, text }) => itemOf(`#${anchor}`, text)).join('')}</ul>` : '';
    return itemOf(`${up}${entry.place}`, entry.text, here ? ' class="here"' : '', sections);
  });
  // The menu is below the text if there is no room beside it.
  return `${headOf(title === 'discmc' ? title : `${escaped(title)} · discmc`, up,
    '<a class="menu" href="#menu">Contents</a>')}<main>
${withCalculator(body)}</main>
<nav id="menu"><ul>
${items.join('\n')}
</ul></nav>
${foot}`;
}

/** @returns {string[]} the links of the repository's files that lead nowhere */
function build(site, frame) {
  const broken = [];
  const write = (place, text) => {
    mkdirSync(dirname(join(site, place)), { recursive: true });
    writeFileSync(join(site, place), text);
  };
  const waiting = ['README.md', 'docs/README.md'];
  const known = new Set(waiting);
  const need = (path) => {
    if (!known.has(path)) waiting.push(path);
    known.add(path);
  };

  /** Where a link of a file leads in the site. */
  function rewritten(from, href) {
    if (isExternal(href) || href.startsWith('#')) return href;
    const [target, anchor] = href.split('#');
    const path = posix.join(posix.dirname(from), target).replace(/\/$/, '');
    if (path.startsWith('..') || !existsSync(join(root, path))) {
      broken.push(`${from}: ${href}`);
      return href;
    }
    const file = readmeOf(path);
    need(file);
    return posix.relative(posix.dirname(placeOf(from)), placeOf(file)) + (anchor ? `#${anchor}` : '');
  }

  function contentOf(path) {
    if (path.endsWith('.md')) return pageOf(read(path), (href) => rewritten(path, href));
    const text = statSync(join(root, path)).isDirectory()
      ? readdirSync(join(root, path)).sort().join('\n') : read(path);
    const body = `<h1>${path}</h1>\n<pre><code>${escaped(text)}</code></pre>\n`;
    return { title: path, headings: [], body };
  }

  while (waiting.length > 0) {
    const path = waiting.shift();
    const place = placeOf(path);
    if (isReference(path)) continue;
    if (isPicture(path)) {
      mkdirSync(dirname(join(site, place)), { recursive: true });
      copyFileSync(join(root, path), join(site, place));
    } else {
      write(place, htmlOf(place, contentOf(path)));
    }
  }
  copyFileSync(join(root, 'docs/site/style.css'), join(site, 'style.css'));
  const indices = { files: 'Headers', annotated: 'Classes', namespacemembers: 'Names of C++',
    modules: 'C', globals: 'Names of C' };
  writeFileSync(join(frame, 'header.html'), `${headOf('$title · discmc', '../')}<main class="reference">
<p class="indices">${Object.entries(indices).map(([name, text]) => `<a href="${name}.html">${text}</a>`).join(' ')}</p>
`);
  writeFileSync(join(frame, 'footer.html'), `</main>\n${foot}`);
  return broken;
}

const broken = build(process.argv[2], process.argv[3]);
for (const link of broken) console.error(`${link}: no such file`);
process.exitCode = broken.length > 0 ? 1 : 0;
