// Measures the speed of the page; not a test. Needs the environment of the tests (CMakeLists.txt).
//   node measure.js VOLUME [FROM TO]      drags the threshold from FROM to TO and back
import { statSync } from 'node:fs';
import { openFiles, openPage, rested, startBrowser } from './browser.js';

const [, , volume, from = '400', to = '900'] = process.argv;
const seconds = 8;
const browser = await startBrowser();
const { page } = await openPage(browser, { viewport: { width: 1280, height: 800 } });

const system = await browser.newBrowserCDPSession();
/** Seconds of processor time, by the kind of process. */
async function used() {
  const { processInfo } = await system.send('SystemInfo.getProcessInfo');
  return Object.fromEntries(['GPU', 'renderer'].map((kind) => [kind, processInfo
    .filter(({ type }) => type === kind).reduce((sum, { cpuTime }) => sum + cpuTime, 0)]));
}
const mean = (list) => (list.reduce((a, b) => a + b, 0) / list.length).toFixed(0);

let begin = performance.now();
await openFiles(page, volume);
await page.waitForFunction(() => globalThis.measured.some(({ name }) => name === 'drawn'));
console.log(`first picture after ${(performance.now() - begin).toFixed(0)} ms`);
await rested(page);

const drag = () => page.evaluate(async ({ from, to, seconds }) => {
  globalThis.measured.length = 0;
  const slider = document.querySelector('#threshold');
  const begin = performance.now();
  for (let i = 0; performance.now() - begin < 1000 * seconds; ++i) {
    const place = (i % 80) / 40;
    slider.value = from + (to - from) * (place < 1 ? place : 2 - place);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    await new Promise(requestAnimationFrame);
  }
  const times = (wanted) => globalThis.measured.filter(({ name }) => name === wanted)
    .map(({ duration }) => duration);
  return { extracted: times('extracted'), drawn: times('drawn'), elapsed: performance.now() - begin };
}, { from: Number(from), to: Number(to), seconds });

await drag(); // the browser compiles frequently used code
const before = await used();
const { extracted, drawn, elapsed } = await drag();
const after = await used();
const each = (kind, count) => ((1000 * (after[kind] - before[kind])) / count).toFixed(0);
console.log(`${((1000 * drawn.length) / elapsed).toFixed(1)} pictures a second, ` +
  `${((1000 * extracted.length) / elapsed).toFixed(1)} surfaces a second`);
console.log(`a surface: ${mean(extracted)} ms; ${each('renderer', extracted.length)} ms of processor time ` +
  'with all that the page does');
console.log(`a picture: ${mean(drawn)} ms; ${each('GPU', drawn.length)} ms of processor time`);
for (const name of ['DISCMC_MODULE', 'DISCMC_PAGE'])
  console.log(`${name}: ${statSync(process.env[name]).size} bytes`);
await browser.close();
