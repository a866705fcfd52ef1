// Which slice is shown, and whether the surface is cut there.
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
    const slice = new SliceView(by('slice'));
    this.pictures = new Newest(
      async (request) => ({ ...request, picture: await engine.call('picture', request) }),
      ({ picture, axis, volume }) => slice.show(picture, axis, volume.dims, volume.spacing),
      fail,
    );
    on('axis', 'change', () => this.setPlaces());
    on('place', 'input', () => this.showPlace());
    on('cut', 'change', () => this.showPlace());
    addEventListener('resize', () => this.ask());
  }

  /** @param {{dims: number[], spacing: number[], values?: any}} volume without values: of a stream */
  open(volume) {
    this.volume = volume;
    by('axis').value = 2;
    by('cut').checked = false;
    this.setPlaces();
  }

  setPlaces() {
    const slider = by('place');
    const extent = Math.max(1, this.volume.dims[Number(by('axis').value)]);
    slider.max = extent - 1;
    slider.value = Math.floor(extent / 2);
    this.showPlace();
  }

  showPlace() {
    const axis = Number(by('axis').value), at = Number(by('place').value);
    by('place-text').textContent = `${at} of ${by('place').max}`;
    this.view.setCut(by('cut').checked ? { axis, at } : null);
    this.ask();
  }

  /** Shows the slice of the surface that is there now. */
  ask() {
    if (!this.volume?.values) return;
    const { dark, bright } = this.volume.values;
    this.pictures.ask({ axis: Number(by('axis').value), place: Number(by('place').value), dark,
      bright, volume: this.volume });
  }
}
