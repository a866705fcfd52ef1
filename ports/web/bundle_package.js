// Makes the npm package of the modules in package/ and the WebAssembly module.
//   node bundle_package.js MODULE.wasm FOLDER
import { copyFileSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'esbuild';

const [, , modulePath, folder] = process.argv;
const source = (name) => new URL(`package/${name}`, import.meta.url).pathname;

mkdirSync(folder, { recursive: true });
for (const name of ['package.json', 'index.d.ts', 'README.md'])
  copyFileSync(source(name), join(folder, name));
copyFileSync(modulePath, join(folder, 'discmc.wasm'));
await build({
  entryPoints: [source('index.js')],
  outfile: join(folder, 'index.js'),
  bundle: true,
  external: ['node:*'],
  format: 'esm',
  target: 'es2022',
  legalComments: 'none',
});
