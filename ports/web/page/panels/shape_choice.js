// The shape in which the surface of a stream is drawn.
import { by, on } from '../elements.js';
import { bestShape } from '../shape.js';

export class ShapeChoice {
  /** @param {() => void} changed */
  constructor(changed) {
    /** What the user chose, also for later streams. @type {import('../shape.js').Shape | null} */
    this.wanted = null;
    on('shape', 'change', () => {
      this.wanted = by('shape').value;
      changed();
    });
  }

  /** Offers what a stream has. @param {number} levels of its fractions; 0: there are none */
  show(levels) {
    if (this.wanted === 'interpolated' && levels === 0) this.wanted = null;
    by('shape-interpolated').disabled = levels === 0;
    by('shape').value = this.wanted ?? bestShape(levels);
  }
}
