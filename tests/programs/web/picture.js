// Makes the first picture of the README: the page with a scan. It is smooth on the left, and shows the edges of merged
// polygons on the right. Needs the environment of the tests (CMakeLists.txt).
//   node picture.js PAGE.html PICTURE.png      a page that `discmc view` has made of a CT
import { writeFileSync } from 'node:fs';
import { now, openPage, rested, shown, startBrowser } from './browser.js';

const [, , path, picture] = process.argv;
const viewport = { width: 1100, height: 660 };
const browser = await startBrowser();
const { page } = await openPage(browser, { path, viewport });
await page.waitForFunction(() => document.querySelector('#polygons').textContent !== '–');
await page.getByRole('button', { name: 'Bone' }).click();
await shown(page, 300);

const keys = { '+': 3, ArrowLeft: 4, ArrowUp: 3, 'Shift+ArrowUp': 1 };
const turned = await now(page);
await page.focus('#view');
for (const [key, times] of Object.entries(keys))
  for (let i = 0; i < times; ++i) await page.keyboard.press(key);
await page.locator('#view').blur(); // without the focus frame

async function shot(begin) {
  await rested(page, begin);
  return `data:image/png;base64,${(await page.screenshot()).toString('base64')}`;
}
const smooth = await shot(turned);
const smoothed = await now(page);
await page.uncheck('#smooth');
await rested(page, smoothed);
const flat = await now(page);
await page.check('#edges');
const edges = await shot(flat);

const { x, y, width, height } = await page.locator('#view').boundingBox();

const both = await browser.newPage({ viewport });
const half = x + width / 2;
await both.setContent(`<body style="margin: 0"><img src="${edges}">
<img src="${smooth}" style="position: absolute; left: 0; top: 0;
  clip-path: xywh(${x}px ${y}px ${width / 2}px ${height}px)">
<div style="position: absolute; left: ${half - 1}px; top: ${y}px; width: 2px; height: ${height}px;
  background: #fff"></div>`);
await both.locator('img').last().evaluate((image) => image.decode());
writeFileSync(picture, await both.screenshot());
await browser.close();
