// compare.js CALCULATOR < SIZES: compares the results of calculator.js with those of the library.
import { readFileSync } from 'node:fs';

const source = readFileSync(process.argv[2], 'utf8');
const sizesOf = new Function(`${source}; return sizesOf;`)();
let count = 0;
let wrong = 0;
for (const line of readFileSync(0, 'utf8').trim().split('\n')) {
  const [width, height, memory, indexBytes, ...expected] = line.trim().split(' ').map(Number);
  const { minimum, slots, holes, used, slices, keySlices } = sizesOf(width, height, memory, indexBytes);
  const found = [minimum, slots, holes, used, slices, keySlices];
  ++count;
  if (found.join() === expected.join()) continue;
  ++wrong;
  console.error(`${width}x${height}, ${memory} bytes, index of ${indexBytes}: ${found}, not ${expected}`);
}
console.log(`${count} settings, ${wrong} wrong`);
process.exitCode = count > 500 && wrong === 0 ? 0 : 1;
