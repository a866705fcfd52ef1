// Which surface of a stream is shown, where a link has several.
import { by, number, on } from '../elements.js';

/** @typedef {{scan: number, channel: number}} Choice */

export class SurfaceChoice {
  /** @param {(choice: Choice) => void} choose */
  constructor(choose) {
    /** @type {Choice[]} */
    this.surfaces = [];
    on('surface', 'change', () => choose(this.surfaces[by('surface').selectedIndex]));
  }

  /**
   * @param {{scan: number, channel: number, threshold: number}[]} surfaces
   * @param {Choice} [chosen] else it is the first
   */
  show(surfaces, chosen) {
    this.surfaces = surfaces;
    by('surface-row').hidden = surfaces.length < 2;
    by('surface').replaceChildren(...surfaces.map(({ scan, channel, threshold }) =>
      new Option(`scan ${scan}, channel ${channel}, threshold ${number(threshold)}`)));
    by('surface').selectedIndex = chosen ? surfaces.findIndex(({ scan, channel }) =>
      scan === chosen.scan && channel === chosen.channel) : 0;
  }
}
