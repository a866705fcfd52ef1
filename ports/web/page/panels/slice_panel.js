// Which slice is shown: that under the pointer, or a chosen one; and whether the surface is cut there.
import { by, on } from '../elements.js';
import { Newest } from '../engine.js';
import { fail } from '../messages.js';
import { SliceView } from '../slice_view.js';

export class SlicePanel {
  /** @param {import('../engine.js').Engine} engine @param {import('../surface_view.js').SurfaceView} view */
  constructor(engine, view) {
    this.view = view;
    /** @type {any} */
    this.volume = null;
    /** @type {number[] | null} */
    this.point = null; // that is followed; Units: voxels
    /** @type {{right: number, up: number} | null} */
    this.pointer = null; // not looked at yet
    const slice = new SliceView(by('slice'));
    this.pictures = new Newest(
      async (request) => ({ ...request, picture: await engine.call('picture', request) }),
      ({ picture, axis, volume, point }) =>
        slice.show(picture, axis, volume.dims, volume.spacing, point),
      fail,
    );
    on('axis', 'change', () => this.setPlaces());
    on('place', 'input', () => {
      by('follow').checked = false; // or the way to the next control would take it elsewhere
      this.showPlace();
    });
    on('follow', 'change', () => this.showPlace());
    on('cut', 'change', () => this.showPlace());
    addEventListener('resize', () => this.ask());
  }

  /** @param {{dims: number[], spacing: number[], values?: any}} volume without values: of a stream */
  open(volume) {
    this.volume = volume;
    by('axis').value = 2;
    by('cut').checked = false;
    by('follow').checked = true;
    by('follow-row').hidden = !volume.values;
    this.setPlaces();
  }

  /**
   * Shows the slice of what is seen there, soon.
   * @param {number} right @param {number} up in the view, from -1 to 1
   */
  follow(right, up) {
    if (!this.volume?.values || !by('follow').checked || by('cut').checked) return;
    if (!this.pointer) requestAnimationFrame(() => this.look());
    this.pointer = { right, up };
  }

  look() {
    const { right, up } = /** @type {{right: number, up: number}} */ (this.pointer);
    this.pointer = null;
    const found = this.view.pick(right, up);
    if (!found) return;
    const { dims, spacing } = this.volume;
    const point = found.map((at, i) => Math.min(dims[i] - 1, Math.max(0, Math.round(at / spacing[i]))));
    by('place').value = point[Number(by('axis').value)];
    this.showPlace(point);
  }

  setPlaces() {
    const slider = by('place');
    const extent = Math.max(1, this.volume.dims[Number(by('axis').value)]);
    slider.max = extent - 1;
    slider.value = Math.floor(extent / 2);
    this.showPlace();
  }

  /** @param {number[] | null} [point] that is followed */
  showPlace(point = null) {
    this.point = point;
    const axis = Number(by('axis').value), at = Number(by('place').value);
    by('place-text').textContent = `${at} of ${by('place').max}`;
    by('follow').disabled = by('cut').checked; // a cut that moves hides what is pointed at
    this.view.setCut(by('cut').checked ? { axis, at } : null);
    this.ask();
  }

  /** Shows the slice of the surface that is there now. */
  ask() {
    if (!this.volume?.values) return;
    const { volume, point } = this;
    const { dark, bright } = volume.values;
    this.pictures.ask({ axis: Number(by('axis').value), place: Number(by('place').value), dark,
      bright, volume, point });
  }
}
