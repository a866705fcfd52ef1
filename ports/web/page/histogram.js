// How often which values are there, behind the slider of the threshold.

const margin = 8; // half of the slider's thumb, so that both have one scale

/**
 * @param {HTMLCanvasElement} canvas @param {number[]} counts in equal steps
 * @param {number} share of the threshold, 0 to 1: bars from there on are of what is on
 * @param {number[]} proposals shares that are marked
 */
export function drawHistogram(canvas, counts, share, proposals) {
  const scale = Math.min(window.devicePixelRatio, 2);
  const width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = width * scale;
  canvas.height = height * scale;
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d', { willReadFrequently: true }));
  context.scale(scale, scale);
  const style = getComputedStyle(canvas);
  const room = width - 2 * margin;
  // Most of a scan is air: by their logarithms the others are seen, too.
  const tallest = Math.log1p(Math.max(...counts));
  const step = room / counts.length;
  counts.forEach((count, i) => {
    const bar = tallest > 0 ? (Math.log1p(count) / tallest) * (height - 4) : 0;
    const isOn = (i + 0.5) / counts.length >= share;
    context.fillStyle = style.getPropertyValue(isOn ? '--bar-on' : '--bar');
    const left = Math.round(margin + i * step), right = Math.round(margin + (i + 1) * step);
    context.fillRect(left, height - bar, right - left, bar);
  });
  context.strokeStyle = style.getPropertyValue('--text');
  context.setLineDash([2, 2]);
  for (const proposal of proposals) {
    const x = Math.round(margin + proposal * room) + 0.5;
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x, height);
    context.stroke();
  }
}
