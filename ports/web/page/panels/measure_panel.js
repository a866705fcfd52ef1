// The distance between two points of the surface.
import { by, on } from '../elements.js';

export class MeasurePanel {
  /** @param {import('../surface_view.js').SurfaceView} view */
  constructor(view) {
    this.view = view;
    on('measure', 'change', () => {
      by('view').classList.toggle('picks', by('measure').checked);
      by('cross').hidden = !by('measure').checked;
      this.clear();
    });
    this.clear();
  }

  /** Forgets the points. */
  clear() {
    /** @type {number[][]} */
    this.points = [];
    this.view.setMarks([]);
    this.show(by('measure').checked
      ? 'Click on the surface, or press Enter in the view for its middle.' : '');
  }

  /** @param {string} text */
  show(text) {
    by('distance').textContent = text;
  }

  /** @param {number} right @param {number} up in the view, from -1 to 1 */
  pick(right, up) {
    if (!by('measure').checked) return;
    const point = this.view.pick(right, up);
    if (!point) return this.show('There is no surface at this point.');
    this.points = this.points.length === 1 ? [this.points[0], point] : [point];
    this.view.setMarks(this.points);
    const [from, to] = this.points;
    this.show(to ? `${Math.hypot(...to.map((at, i) => at - from[i])).toFixed(2)} mm`
      : `From ${from.map((at, i) => (at + this.view.origin[i]).toFixed(1)).join(', ')} mm to …`);
  }
}
