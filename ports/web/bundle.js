// Makes one self-contained page of the modules in page/ and the WebAssembly module.
//   node bundle.js MODULE.wasm PAGE.html
import { readFileSync, writeFileSync } from 'node:fs';
import { deflateSync } from 'node:zlib';
import { build } from 'esbuild';

const [, , modulePath, pagePath] = process.argv;
const folder = new URL('page/', import.meta.url);

async function script(name) {
  const { outputFiles } = await build({
    entryPoints: [new URL(name, folder).pathname],
    bundle: true,
    format: 'iife',
    minify: true,
    target: 'es2022',
    legalComments: 'none',
    write: false,
  });
  return outputFiles[0].text.replaceAll('</script', '<\\/script');
}

// ogl requires no licence text.
const licences = ['dicom-parser', 'jpeg-lossless-decoder-js'].map((name) => {
  const text = readFileSync(new URL(`node_modules/${name}/LICENSE`, import.meta.url), 'utf8');
  return `With code of ${name}:\n\n${text.trim()}\n`;
}).join('\n');

const parts = [
  ['<!doctype html>', `<!doctype html>\n<!--\n${licences}-->`],
  ['<style>/* style.css */</style>',
    `<style>${readFileSync(new URL('style.css', folder), 'utf8')}</style>`],
  ['id="module"></script>',
    `id="module">${deflateSync(readFileSync(modulePath), { level: 9 }).toString('base64')}</script>`],
  ['id="worker"></script>', `id="worker">${await script('worker.js')}</script>`],
  ['<script></script>', `<script>${await script('main.js')}</script>`],
];
let page = readFileSync(new URL('index.html', folder), 'utf8');
for (const [place, part] of parts) {
  if (!page.includes(place)) throw new Error(`page/index.html has no ${place}`);
  page = page.replace(place, () => part);
}
writeFileSync(pagePath, page);
