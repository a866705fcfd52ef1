// A slice of the volume, grey, with the outline of the surface.
import { outline } from './outline.js';
import { skyBlue, vermilion } from './palette.js';

export class SliceView {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.shades = document.createElement('canvas');
  }

  /**
   * @param {Uint8Array} picture see Module.picture() @param {number} axis across the slice
   * @param {number[]} dims @param {number[]} spacing
   * @param {number[] | null} point a voxel to mark
   */
  show(picture, axis, dims, spacing, point) {
    const [along, across] = [0, 1, 2].filter((each) => each !== axis);
    const [width, height] = [dims[along], dims[across]];
    const isUpwards = axis !== 2; // z is up; in a slice across z, y runs down
    this.fillShades(picture, width, height);
    const { canvas } = this;
    const [wide, high] = [width * Math.abs(spacing[along]), height * Math.abs(spacing[across])];
    canvas.style.aspectRatio = `${wide} / ${high}`;
    const scale = Math.min(window.devicePixelRatio, 2);
    const box = canvas.parentElement;
    const fit = Math.min(box.clientWidth / wide, Math.min(box.clientWidth, 320) / high);
    canvas.style.width = `${Math.round(wide * fit)}px`;
    canvas.width = Math.round(wide * fit * scale);
    canvas.height = Math.round(high * fit * scale);
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d', { willReadFrequently: true }));
    context.imageSmoothingEnabled = false;
    const x = canvas.width / width, y = canvas.height / height;
    context.setTransform(x, 0, 0, isUpwards ? -y : y, 0, isUpwards ? canvas.height : 0);
    context.drawImage(this.shades, 0, 0);
    context.beginPath();
    outline(picture, width, height, (x1, y1, x2, y2) => {
      context.moveTo(x1 + 0.5, y1 + 0.5);
      context.lineTo(x2 + 0.5, y2 + 0.5);
    });
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.lineWidth = 1.4 * scale;
    context.strokeStyle = vermilion;
    context.stroke();
    if (!point) return;
    const down = (point[across] + 0.5) * y;
    const [right, below] = [(point[along] + 0.5) * x, isUpwards ? canvas.height - down : down];
    context.beginPath();
    context.moveTo(right, 0);
    context.lineTo(right, canvas.height);
    context.moveTo(0, below);
    context.lineTo(canvas.width, below);
    context.lineWidth = scale;
    context.strokeStyle = skyBlue;
    context.stroke();
  }

  /** @param {Uint8Array} picture @param {number} width @param {number} height */
  fillShades(picture, width, height) {
    this.shades.width = width;
    this.shades.height = height;
    const context = /** @type {CanvasRenderingContext2D} */ (this.shades.getContext('2d'));
    const image = context.createImageData(width, height);
    const pixels = new Uint32Array(image.data.buffer);
    for (let i = 0; i < pixels.length; ++i)
      pixels[i] = 0xff000000 | ((picture[i] & 127) * 0x020202);
    context.putImageData(image, 0, 0);
  }
}
