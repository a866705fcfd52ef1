// The threshold: a slider on the histogram, a number, and proposals.
import { by, number, on } from '../elements.js';
import { drawHistogram } from '../histogram.js';

export class ThresholdPanel {
  /** @param {() => void} changed */
  constructor(changed) {
    this.changed = changed;
    this.iso = 0;
    /** @type {any} */
    this.values = null;
    on('threshold', 'input', () => this.set(Number(by('threshold').value)));
    on('threshold-number', 'change', () => {
      const iso = by('threshold-number').valueAsNumber;
      if (Number.isFinite(iso)) this.set(iso);
    });
    addEventListener('resize', () => this.draw());
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
  }

  /** Takes another volume. @param {any} values see Module.measure() @param {import('../formats/volume_info.js').VolumeInfo} info */
  open(values, info) {
    this.values = values;
    const slider = by('threshold');
    slider.min = values.least;
    slider.max = values.greatest;
    const range = values.greatest - values.least;
    const isWhole = !info.type.startsWith('f');
    slider.step = isWhole && range / info.slope <= 1e5 ? info.slope : range / 1000 || 1;
    const isInHounsfield = info.isInHounsfield || !Number.isNaN(values.bone);
    by('unit').textContent = isInHounsfield ? 'HU' : '';
    by('proposals').replaceChildren(...this.proposals().map(([name, iso]) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = `${name} ${number(iso)}`;
      button.onclick = () => this.set(iso);
      return button;
    }));
  }

  /** @returns {[string, number][]} */
  proposals() {
    const { otsu, bone, skin } = this.values;
    const named = /** @type {[string, number][]} */ ([['Otsu', otsu], ['Bone', bone], ['Skin', skin]]);
    return named.filter(([, iso]) => !Number.isNaN(iso));
  }

  /** @param {number} iso */
  set(iso) {
    this.iso = iso;
    by('threshold').value = iso;
    by('threshold-number').value = Number(iso.toPrecision(8));
    this.draw();
    this.changed();
  }

  draw() {
    if (!this.values) return;
    const { least, greatest, histogram } = this.values;
    const share = (/** @type {number} */ iso) => (iso - least) / (greatest - least || 1);
    drawHistogram(by('histogram'), histogram, share(this.iso),
      this.proposals().map(([, iso]) => share(iso)));
  }
}
