// Other programs read the files that the page saves; here the command reads them.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { glb } from '../../../ports/web/page/save/glb.js';
import { meshOf } from '../../../ports/web/page/save/mesh.js';
import { stl } from '../../../ports/web/page/save/stl.js';
import { nrrdOf, roughBall } from './ball.js';
import { command, workFolder } from './command.js';
import { openVolume } from './module_of_page.js';

const folder = workFolder(after);
const file = join(folder, 'ball.nrrd');
writeFileSync(file, nrrdOf(roughBall(20, 18, 16)));

/** Six times the volume inside. */
function enclosed({ places, corners }) {
  let sum = 0;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((j) => places.subarray(3 * corners[i + j], 3 * corners[i + j] + 3));
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
      a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

for (const [name, write] of Object.entries({ stl, glb }))
  for (const side of [1, -1])
    test(`${name} of a volume whose x runs ${side > 0 ? 'forwards' : 'backwards'} lies where the command's does`, async () => {
      const { info, module } = await openVolume(file);
      module.extract(600, false);
      const { vertices, triangles } = module.draw();
      const spacing = [side * info.spacing[0], info.spacing[1], info.spacing[2]];
      const mesh = meshOf(new Int16Array(vertices.buffer), new Uint32Array(triangles.buffer), spacing);
      const path = join(folder, `saved.${name}`);
      writeFileSync(path, Buffer.from(await write(mesh).arrayBuffer()));
      const volume = join(folder, 'turned.nrrd');
      writeFileSync(volume, nrrdOf({ ...roughBall(20, 18, 16), spacing }));
      const expected = join(folder, `expected.${name}`);
      command('extract', '--quiet', volume, '--iso', '600', '-o', expected);
      const told = command('compare', expected, path).toString();
      assert.match(told, /A to B, mm +0.0000 +0.0000 +0.0000\n.*B to A, mm +0.0000 +0.0000 +0.0000/);
      assert.ok(enclosed(mesh) > 0, 'faces are counter-clockwise from outside');
    });
