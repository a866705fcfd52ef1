// The page: what is open, and who is notified of changes.
import { takeDropped } from './dropped.js';
import { by, counted, number, on, whole } from './elements.js';
import { embeddedFile, embeddedModule, servedFile } from './embedded.js';
import { Engine, EngineError, Newest } from './engine.js';
import { servedWhole } from './live/served.js';
import { fail, hideError, showBusy, showError } from './messages.js';
import { navigate } from './navigation.js';
import { DevicePanel } from './panels/device_panel.js';
import { LivePanel } from './panels/live_panel.js';
import { MeasurePanel } from './panels/measure_panel.js';
import { MissingPanel } from './panels/missing_panel.js';
import { showLabels } from './panels/labels.js';
import { askLayout } from './panels/raw_dialog.js';
import { SavePanel } from './panels/save_panel.js';
import { ShapeChoice } from './panels/shape_choice.js';
import { SlicePanel } from './panels/slice_panel.js';
import { SurfaceChoice } from './panels/surface_choice.js';
import { ThresholdPanel } from './panels/threshold_panel.js';
import { SurfaceView } from './surface_view.js';
import { record } from './timing.js';

const settled = 250; // milliseconds without another surface

class Page {
  /** @param {Engine} engine @param {SurfaceView} view */
  constructor(engine, view) {
    this.engine = engine;
    this.view = view;
    /** @type {any} */
    this.opened = null;
    this.shownIso = 0;
    this.threshold = new ThresholdPanel(() => this.askSurface());
    this.slice = new SlicePanel(engine, view);
    this.device = new DevicePanel(engine);
    this.live = new LivePanel(engine, (...arrived) => this.showArrived(...arrived),
      () => this.streamWishes());
    this.shape = new ShapeChoice(() => {
      showBusy('Triangulating…');
      this.redrawStream();
    });
    this.choice = new SurfaceChoice((choice) =>
      this.open([new File([/** @type {Blob} */ (this.live.recorded)], this.opened.name)], { choice }));
    this.measure = new MeasurePanel(view);
    this.missing = new MissingPanel(view);
    this.save = new SavePanel(engine, view, () => this.stem(),
      () => (this.opened.values ? null : this.live.stream()));
    this.surfaces = new Newest((request) => engine.call('surface', request),
      (surface) => this.showSurface(surface), fail);
    this.classics = new Newest(() => engine.call('classic'),
      (classic) => this.showClassic(classic), fail);
    this.connect();
  }

  connect() {
    on('open', 'click', () => by('files').click());
    on('files', 'change', () => {
      this.open([...by('files').files]);
      by('files').value = '';
    });
    takeDropped((files) => this.open(files));
    for (const id of ['filter', 'edges', 'smooth']) on(id, 'change', () => this.askSurface());
    on('colouring', 'change', () => {
      this.view.setColouring(Number(by('colouring').value));
      by('legend').hidden = by('colouring').value !== '1';
    });
    on('classic', 'change', () => {
      by('caption-classic').hidden = true;
      if (!by('classic').checked) return this.view.setClassic(null);
      showBusy('Classic Marching Cubes…');
      this.classics.ask({});
    });
    navigate(by('view'), this.view.camera, {
      changed: () => this.view.draw(),
      picked: (right, up) => {
        this.measure.pick(right, up);
        this.slice.follow(right, up);
      },
      pointed: (right, up) => this.slice.follow(right, up),
      home: () => this.view.home(),
    });
  }

  /**
   * Opens a volume, a mesh or a stream; if that fails, what is open stays.
   * @param {File[]} files
   * @param {{layout?: import('./formats/raw.js').RawLayout, iso?: number,
   *   choice?: import('./panels/surface_choice.js').Choice}} [wishes]
   */
  async open(files, { layout, iso, choice } = {}) {
    if (files.length === 0) return;
    hideError();
    showBusy('Reading…');
    this.live.leave();
    try {
      const opened = await this.engine.call('open', { files, layout, choice });
      this.live.open(opened.name, opened.info || opened.mesh ? null : files[0]);
      if (opened.info) this.showVolume(opened, iso);
      else if (opened.mesh) this.showMesh(opened);
      else await this.showStream(opened, choice);
    } catch (error) {
      const unknown = error instanceof EngineError && error.unknownLayout;
      if (!unknown) return fail(/** @type {Error} */ (error));
      showBusy('');
      const answer = await askLayout(unknown);
      if (answer) await this.open(files.filter(({ name }) => name === unknown.name), { layout: answer });
    }
  }

  /** @param {{name: string, source: string, isLive: boolean}} served */
  async openServed({ name, source, isLive }) {
    if (isLive) return this.live.fetch(name, source);
    try {
      const file = await servedWhole(name, source,
        (share) => showBusy(`Loading… ${Math.floor(100 * share)} %`));
      await this.open([file]);
    } catch (error) {
      fail(/** @type {Error} */ (error));
    }
  }

  /** @param {any} volume @param {number} [iso] */
  showVolume({ name, info, values }, iso) {
    this.opened = { name, dims: info.dims, spacing: info.spacing, upright: info.upright, values };
    this.showOpened(true);
    this.threshold.open(values, info);
    const first = iso ?? values.automatic;
    this.threshold.set(Number.isNaN(first) ? values.greatest : first);
  }

  /** @param {{name: string, mesh: import('./formats/glb.js').DrawnMesh}} opened */
  showMesh({ name, mesh }) {
    const { size, step, origin } = mesh;
    this.opened = { name, mesh, dims: size.map((length) => Math.floor(length / step) + 1),
      spacing: [step, step, step], origin };
    this.showOpened(false);
    by('file-name').textContent = `${name} · ${size.map(number).join(' × ')} mm`;
    by('caption-merged').textContent = counted(mesh.triangles.length / 3, 'triangle');
    this.view.setMesh(mesh);
    this.askSurface();
    showBusy('');
  }

  /** @param {any} result @param {import('./panels/surface_choice.js').Choice} [choice] */
  async showStream({ name, stream, surfaces, missing }, choice) {
    this.opened = { name, dims: stream.dims, spacing: stream.spacing, upright: stream.upright };
    this.choice.show(surfaces, choice);
    this.showOpened(stream.isComplete && stream.isClosed);
    this.shape.show(stream.levels);
    this.reportStream(stream);
    this.missing.show(missing);
    await this.redrawStream();
  }

  /**
   * What of a stream has arrived so far.
   * @param {string} name @param {any} arrived @param {boolean} isFirst @param {boolean} isEnd
   */
  showArrived(name, { stream, surface, surfaces, missing }, isFirst, isEnd) {
    this.choice.show(isEnd ? surfaces : []);
    if (isFirst || (isEnd && stream.dims[2] !== this.opened.dims[2])) {
      const [width, height, depth] = stream.dims; // a stream may state it only at its end
      this.opened = { name, dims: [width, height, depth || Math.max(width, height)],
        spacing: stream.spacing, upright: stream.upright };
      this.showOpened(stream.isComplete && stream.isClosed, true);
      this.shape.show(stream.levels);
    }
    this.missing.show(missing);
    if (isEnd) this.reportStream(stream);
    else this.reportArriving(stream);
    this.showStreamSurface(surface);
  }

  /** @param {any} stream */
  reportArriving(stream) {
    const lost = stream.lostPackets > 0 ? `, ${counted(stream.lostPackets, 'packet')} lost` : '';
    by('stream-text').textContent = `Arriving: ${whole(stream.bytes)} bytes${lost}.`;
    this.showCounts(stream.polygons, 0);
  }

  /** @param {any} stream at its end */
  reportStream(stream) {
    const pieces = stream.holdsSlices ? counted(stream.lostPieces, 'row')
      : `${whole(stream.lostPieces)} regions or fragments`;
    by('stream-text').textContent = stream.isComplete
      ? `Complete: ${whole(stream.bytes)} bytes, threshold ${number(stream.threshold)}.`
      : `Incomplete: ${counted(stream.lostPackets, 'packet')} and ${pieces} lost` +
        `${stream.hasTrailer ? '' : ', the end missing'}; ` +
        `${counted(stream.damagedPackets, 'packet')} damaged. The page shows what arrived.`;
    this.showCounts(stream.polygons, stream.classicTriangles);
  }

  /**
   * @param {boolean} isClosed whether no inside can be seen
   * @param {boolean} [isGrowing] whether more will arrive
   */
  showOpened(isClosed, isGrowing) {
    clearTimeout(this.settling);
    const { name, dims, spacing, values, mesh } = this.opened;
    for (const id of ['threshold-section', 'slice-section', 'device-section', 'classic-row', 'time',
      'time-name'])
      by(id).hidden = !values;
    by('smooth-row').hidden = !values && !mesh?.normals;
    by('stream-section').hidden = by('shape-row').hidden = Boolean(values || mesh);
    by('figures').hidden = by('colouring-row').hidden = Boolean(mesh);
    showLabels(mesh?.parts ?? []);
    this.save.open(Boolean(mesh));
    document.body.classList.add('opened');
    document.title = `${name} – discmc`;
    const size = spacing.map((/** @type {number} */ step) => number(Math.abs(step))).join(' × ');
    by('file-name').textContent = `${name} · ${dims.join(' × ')} voxels of ${size} mm`;
    by('start').hidden = true;
    by('side').hidden = false;
    this.measure.clear();
    this.view.setClassic(null);
    this.view.setMissing(null);
    by('caption-classic').hidden = true;
    this.view.setSpace(this.opened, isClosed, isGrowing);
    this.slice.open(this.opened);
  }

  askSurface() {
    this.view.hasEdges = by('edges').checked;
    if (!this.opened) return;
    if (this.opened.mesh || this.opened.isMoved) return this.view.setFlat(!by('smooth').checked);
    if (!this.opened.values) return void this.redrawStream();
    clearTimeout(this.settling); // of a large volume a surface takes longer than that
    this.surfaces.ask({ iso: this.threshold.iso, isFiltered: by('filter').checked,
      hasEdges: this.view.hasEdges, isSmooth: by('smooth').checked });
  }

  /** @param {any} surface */
  showSurface(surface) {
    const { iso, counts, milliseconds } = surface;
    record('extracted', performance.now() - milliseconds, milliseconds, { iso, ...counts });
    showBusy('');
    if (iso !== this.shownIso) this.measure.clear();
    this.shownIso = iso;
    this.view.setSurface(surface);
    this.showCounts(counts.polygons, counts.classicTriangles);
    by('time').textContent = `${whole(milliseconds)} ms`;
    this.slice.ask();
    // What need not follow a slider at once.
    clearTimeout(this.settling);
    this.settling = setTimeout(() => {
      this.device.ask();
      if (by('classic').checked) this.classics.ask({});
    }, settled);
  }

  /** @param {any} classic */
  showClassic(classic) {
    showBusy('');
    if (!by('classic').checked) return;
    this.view.setClassic(classic);
    const triangles = whole(classic.triangles.byteLength / 12);
    by('caption-classic').textContent = `${triangles} triangles of classic Marching Cubes`;
    by('caption-classic').hidden = false;
  }

  /** @param {number} polygons @param {number} triangles of classic Marching Cubes; 0: not known */
  showCounts(polygons, triangles) {
    by('polygons').textContent = whole(polygons);
    by('classic-count').textContent = triangles > 0 ? `${whole(triangles)} triangles` : '–';
    by('ratio').textContent = polygons > 0 && triangles > 0 ? (triangles / polygons).toFixed(1) : '–';
    by('caption-merged').textContent = polygons === 0 && this.opened.values
      ? 'No surface at this threshold' : `${whole(polygons)} merged polygons`;
  }

  /** How a stream is drawn. @returns {import('./worker.js').Wishes} */
  streamWishes() {
    return { hasEdges: by('edges').checked, shape: this.shape.wanted };
  }

  /** @param {any} surface polygons, or a mesh */
  showStreamSurface(surface) {
    const isMoved = this.opened.isMoved = surface.places !== undefined;
    by('smooth-row').hidden = !isMoved;
    by('colouring-row').hidden = isMoved;
    by('legend').hidden = isMoved || by('colouring').value !== '1';
    by('caption-merged').textContent = isMoved
      ? `${whole(surface.triangles.length / 3)} triangles, ${surface.shape}`
      : `${by('polygons').textContent} merged polygons`;
    this.view.setFlat(!by('smooth').checked);
    this.view.setSurface(surface);
  }

  async redrawStream() {
    try {
      const surface = await this.engine.call('redraw', this.streamWishes());
      this.showStreamSurface(surface);
      showBusy('');
      if (surface.leftOut > 0)
        showError(`${this.opened.name}: ${whole(surface.leftOut)} polygons are invalid and ` +
          'left out; the stream may be damaged, or from another program');
    } catch (error) {
      fail(/** @type {Error} */ (error));
    }
  }

  stem() {
    const stem = this.opened.name.replace(/\.gz$/i, '').replace(/\.[^.]*$/, '');
    return this.opened.values ? `${stem}-${Number(this.shownIso.toPrecision(6))}` : stem;
  }
}

async function start() {
  try {
    const view = new SurfaceView(by('view'));
    const page = new Page(new Engine(by('worker').textContent, await embeddedModule()), view);
    const embedded = await embeddedFile();
    if (embedded) await page.open([embedded.file], { iso: embedded.iso });
    const served = servedFile();
    if (served) page.openServed(served);
    document.body.dataset.ready = '';
  } catch (error) {
    showError(`The page cannot start: ${/** @type {Error} */ (error).message} ` +
      'The page needs a browser of 2023 or later with WebGL 2 and WebAssembly.');
  }
}

start();
