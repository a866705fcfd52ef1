// A generated volume: a ball with a rough surface.

/** @returns {{dims: number[], spacing: number[], samples: Int16Array}} */
export function roughBall(width = 48, height = 40, depth = 36) {
  const samples = new Int16Array(width * height * depth);
  let noise = 1;
  let i = 0;
  for (let z = 0; z < depth; ++z)
    for (let y = 0; y < height; ++y)
      for (let x = 0; x < width; ++x) {
        noise = (noise * 1103515245 + 12345) & 0x7fffffff; // a generator of C's standard
        const away = Math.hypot(x - width / 2 + 0.3, y - height / 2, 1.3 * (z - depth / 2));
        samples[i++] = Math.round(1000 - 55 * away + ((noise >> 16) % 160));
      }
  return { dims: [width, height, depth], spacing: [0.5, 0.75, 1.25], samples };
}

/** As a NRRD file. */
export function nrrdOf({ dims, spacing, samples }, fields = '') {
  const header = `NRRD0004\ntype: short\ndimension: 3\nsizes: ${dims.join(' ')}\n` +
    `spacings: ${spacing.join(' ')}\nendian: little\nencoding: raw\n${fields}\n`;
  return Buffer.concat([Buffer.from(header), Buffer.from(samples.buffer)]);
}
