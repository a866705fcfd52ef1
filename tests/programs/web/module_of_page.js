// The module and the readers of the page, without a browser.
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { swapBytes } from '../../../ports/web/page/formats/bytes.js';
import { openFiles } from '../../../ports/web/page/formats/volume_file.js';
import { sampleBytes, sampleTypes, volumeBytes } from '../../../ports/web/page/formats/volume_info.js';
import { Module } from '../../../ports/web/page/module.js';
import { jsonl } from '../../../ports/web/page/save/jsonl.js';
import { inOrder } from './command.js';

export const startModule = () => Module.start(readFileSync(process.env.DISCMC_MODULE));

/** A file as a browser hands it over. */
export const asFile = (path) => Object.assign(new Blob([readFileSync(path)]), { name: basename(path) });

/** A volume in a module of its own. */
export async function openVolume(paths, layout) {
  const { info, data } = await openFiles([].concat(paths).map(asFile), layout);
  const module = await startModule();
  const samples = module.newVolume(info, sampleTypes.indexOf(info.type), volumeBytes(info));
  const filled = await data.fill(samples);
  if (filled < samples.length) throw new Error(`ends after ${filled} bytes`);
  if (info.bigEndian) swapBytes(samples, sampleBytes(info.type));
  return { info, module };
}

/** The polygons that a module holds, as inOrder() has them. */
export const polygonsOf = async (module) => inOrder(await jsonl(module.polygons()).text());
