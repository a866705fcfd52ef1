// Where something of a stream is missing: its slices, and its outline in the picture.
import { by, on } from '../elements.js';

const mostRanges = 8; // that are listed

/** @param {[number, number]} range */
const rangeText = ([first, last]) => (first === last ? `${first}` : `${first} to ${last}`);

/** @param {[number, number][]} slices */
function slicesText(slices) {
  const listed = slices.slice(0, mostRanges).map(rangeText).join(', ');
  const more = slices.length > mostRanges ? `, and ${slices.length - mostRanges} more places` : '';
  const isOne = slices.length === 1 && slices[0][0] === slices[0][1];
  return `Missing in slice${isOne ? '' : 's'} ${listed}${more}.`;
}

export class MissingPanel {
  /** @param {import('../surface_view.js').SurfaceView} view */
  constructor(view) {
    this.view = view;
    /** @type {Uint8Array | null} */
    this.lines = null;
    on('missing', 'change', () => this.draw());
  }

  /** @param {{lines: Uint8Array, slices: [number, number][]}} missing */
  show({ lines, slices }) {
    this.lines = lines;
    by('missing-row').hidden = slices.length === 0;
    by('missing-text').textContent = slices.length > 0 ? slicesText(slices) : '';
    this.draw();
  }

  draw() {
    this.view.setMissing(by('missing').checked ? this.lines : null);
  }
}
