// The page: what is open, what the controls say, and what is shown of it.
import { droppedFiles } from './dropped.js';
import { embeddedFile, embeddedModule } from './embedded.js';
import { Engine, EngineError, Newest } from './engine.js';
import { proposedLayout } from './formats/raw.js';
import { sampleTypes } from './formats/volume_info.js';
import { drawHistogram } from './histogram.js';
import { navigate } from './navigation.js';
import { glb } from './save/glb.js';
import { jsonl } from './save/jsonl.js';
import { meshOf } from './save/mesh.js';
import { stl } from './save/stl.js';
import { SliceView } from './slice_view.js';
import { SurfaceView } from './surface_view.js';
import { told } from './timing.js';

/** @template {HTMLElement} Element @param {string} id @returns {any} */
const by = (id) => document.getElementById(id);
const number = (/** @type {number} */ value) => value.toLocaleString('en', { maximumSignificantDigits: 6 });
const whole = (/** @type {number} */ value) => Math.round(value).toLocaleString('en');

/** @type {Engine} */ let engine;
/** @type {SurfaceView} */ let view;
const slice = new SliceView(by('slice'));

/** What is open. @type {any} */
let opened = null;
/** The threshold that is shown, and the one that is asked for. */
let shownIso = 0;
/** @type {number[][]} */
let marks = [];

// ---- messages ----

function tellError(/** @type {string} */ text) {
  by('error-text').textContent = text;
  by('error').hidden = false;
}
function hideError() {
  by('error').hidden = true;
}
function tellBusy(/** @type {string} */ text) {
  by('busy').textContent = text;
  by('busy').hidden = text === '';
}
const fail = (/** @type {Error} */ error) => tellError(error.message);

// ---- opening ----

/** @param {File[]} files @param {object} [layout] @param {number} [iso] */
async function open(files, layout, iso) {
  if (files.length === 0) return;
  hideError();
  tellBusy('Reading…');
  try {
    const result = await engine.call('open', { files, layout });
    if (result.info) showVolume(result, iso);
    else await showStream(result);
  } catch (error) {
    tellBusy('');
    if (error instanceof EngineError && error.unknownLayout)
      askLayout(files, error.unknownLayout);
    else fail(/** @type {Error} */ (error));
  }
}

/** @param {File[]} files @param {{name: string, size: number}} file */
function askLayout(files, file) {
  const dialog = by('raw'), form = by('raw-form').elements;
  const proposed = proposedLayout(file.name, file.size);
  by('raw-text').textContent =
    `${file.name} (${whole(file.size)} bytes) does not tell what it holds.`;
  ['x', 'y', 'z'].forEach((axis, i) => (form[axis].value = proposed.dims[i]));
  form.type.value = proposed.type;
  dialog.returnValue = '';
  dialog.showModal();
  dialog.onclose = () => {
    if (dialog.returnValue !== 'open') return;
    const numbers = (/** @type {string[]} */ names) => names.map((name) => Number(form[name].value));
    open(files.filter(({ name }) => name === file.name), {
      dims: numbers(['x', 'y', 'z']), type: form.type.value, bigEndian: form.big.checked,
      spacing: numbers(['dx', 'dy', 'dz']),
    });
  };
}

/**
 * @param {string} name @param {number[]} dims @param {number[]} spacing @param {boolean} isClosed
 */
function showOpened(name, dims, spacing, isClosed) {
  document.body.classList.add('opened');
  document.title = `${name} – discmc`;
  const size = spacing.map((step) => number(Math.abs(step))).join(' × ');
  by('file-name').textContent = `${name} · ${dims.join(' × ')} voxels of ${size} mm`;
  by('start').hidden = true;
  by('side').hidden = false;
  marks = [];
  by('distance').textContent = '';
  view.setMarks(marks);
  view.setClassic(null);
  view.setSpace(dims, spacing, isClosed);
  by('axis').value = 2;
  by('cut').checked = false;
  view.setCut(null);
  setPlaces();
}

/** @param {any} volume @param {number} [iso] */
function showVolume(volume, iso) {
  opened = { ...volume, dims: volume.info.dims, spacing: volume.info.spacing, isVolume: true };
  showSections(true);
  showOpened(volume.name, opened.dims, opened.spacing, true);
  const { values } = volume;
  const isWhole = !/^f/.test(volume.info.type);
  const slider = by('threshold');
  slider.min = values.least;
  slider.max = values.greatest;
  const range = values.greatest - values.least;
  slider.step = isWhole && range / volume.info.slope <= 1e5 ? volume.info.slope : range / 1000 || 1;
  by('unit').textContent = volume.info.isInHounsfield || !Number.isNaN(values.bone) ? 'HU' : '';
  showProposals();
  const first = iso ?? values.automatic;
  setThreshold(Number.isNaN(first) ? values.greatest : first);
}

/** @param {any} result */
async function showStream({ name, stream }) {
  opened = { name, stream, dims: stream.dims, spacing: stream.spacing, isVolume: false };
  showSections(false);
  showOpened(name, opened.dims, opened.spacing, stream.isComplete && stream.isClosed);
  const missing = stream.holdsSlices ? 'rows' : 'regions or pieces of them';
  by('stream-text').textContent = stream.isComplete
    ? `Complete: ${whole(stream.bytes)} bytes, threshold ${number(stream.threshold)}.`
    : `Incomplete: ${whole(stream.lostPackets)} packets and ${whole(stream.lostPieces)} ${missing} ` +
      `are missing${stream.hasTrailer ? '' : ', and its end'}; ` +
      `${whole(stream.damagedPackets)} packets are damaged. What is whole is shown.`;
  by('polygons').textContent = whole(stream.polygons);
  by('classic-count').textContent =
    stream.classicTriangles > 0 ? `${whole(stream.classicTriangles)} triangles` : '–';
  by('caption-merged').textContent = `${whole(stream.polygons)} merged polygons`;
  await redrawStream();
}

async function redrawStream() {
  try {
    const surface = await engine.call('redraw', { hasEdges: by('edges').checked });
    view.setSurface(surface);
    if (surface.leftOut > 0)
      tellError(`${opened.name}: ${whole(surface.leftOut)} polygons are not valid and are left out; ` +
        'check where the stream is from');
    tellBusy('');
  } catch (error) {
    tellBusy('');
    fail(/** @type {Error} */ (error));
  }
}

/** @param {boolean} isVolume */
function showSections(isVolume) {
  for (const id of ['threshold-section', 'slice-section', 'device-section', 'smooth-row',
    'classic-row', 'save-dmc', 'time', 'time-name', 'ratio', 'ratio-name'])
    by(id).hidden = !isVolume;
  by('stream-section').hidden = isVolume;
}

// ---- the threshold ----

function showProposals() {
  const { values } = opened;
  const named = { Otsu: values.otsu, Bone: values.bone, Skin: values.skin };
  const buttons = Object.entries(named).filter(([, iso]) => !Number.isNaN(iso)).map(([name, iso]) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = `${name} ${number(iso)}`;
    button.onclick = () => setThreshold(iso);
    return button;
  });
  by('proposals').replaceChildren(...buttons);
}

/** @param {number} iso */
function setThreshold(iso) {
  by('threshold').value = iso;
  by('threshold-number').value = Number(iso.toPrecision(8));
  opened.iso = iso;
  askSurface();
}

function showHistogram() {
  if (!opened?.isVolume) return;
  const { values } = opened;
  const range = values.greatest - values.least || 1;
  const share = (/** @type {number} */ iso) => (iso - values.least) / range;
  const proposals = [values.otsu, values.bone, values.skin].filter((iso) => !Number.isNaN(iso));
  drawHistogram(by('histogram'), values.histogram, share(opened.iso), proposals.map(share));
}

const surfaces = new Newest(
  (request) => engine.call('surface', request),
  (surface) => {
    told('extracted', performance.now() - surface.milliseconds, surface.milliseconds,
      { iso: surface.iso, ...surface.counts });
    tellBusy('');
    shownIso = surface.iso;
    view.setSurface(surface);
    showCounts(surface);
    askPicture();
    settle();
  },
  (error) => {
    tellBusy('');
    fail(error);
  },
);

function askSurface() {
  if (!opened) return;
  showHistogram();
  if (!opened.isVolume) return void redrawStream();
  surfaces.ask({ iso: opened.iso, isFiltered: by('filter').checked, hasEdges: by('edges').checked,
    isSmooth: by('smooth').checked });
}

/** @param {any} surface */
function showCounts({ counts, milliseconds }) {
  by('polygons').textContent = whole(counts.polygons);
  by('classic-count').textContent = `${whole(counts.classicTriangles)} triangles`;
  by('ratio').textContent =
    counts.polygons > 0 ? (counts.classicTriangles / counts.polygons).toFixed(1) : '–';
  by('time').textContent = `${whole(milliseconds)} ms`;
  by('caption-merged').textContent = `${whole(counts.polygons)} merged polygons`;
}

// What need not follow a slider at once.
let settling = 0;
function settle() {
  clearTimeout(settling);
  settling = setTimeout(() => {
    askDevice();
    if (by('classic').checked) classics.ask({});
  }, 250);
}

const classics = new Newest(
  () => engine.call('classic'),
  (classic) => {
    tellBusy('');
    if (!by('classic').checked) return;
    view.setClassic(classic);
    const triangles = whole(classic.triangles.byteLength / 12);
    by('caption-classic').textContent = `${triangles} triangles of Marching Cubes`;
    by('caption-classic').hidden = false;
  },
  fail,
);

// ---- the slice ----

const pictures = new Newest(
  async (request) => ({ ...request, picture: await engine.call('picture', request) }),
  ({ picture, axis }) => slice.show(picture, axis, opened.dims, opened.spacing),
  fail,
);

function askPicture() {
  if (!opened?.isVolume) return;
  const { dark, bright } = opened.values;
  pictures.ask({ axis: Number(by('axis').value), place: Number(by('place').value), dark, bright });
}

function setPlaces() {
  const slider = by('place');
  const extent = Math.max(1, opened.dims[Number(by('axis').value)]);
  slider.max = extent - 1;
  slider.value = Math.floor(extent / 2);
  showPlace();
}

function showPlace() {
  const axis = Number(by('axis').value), at = Number(by('place').value);
  by('place-text').textContent = `${at} of ${by('place').max}`;
  view.setCut(by('cut').checked ? { axis, at } : null);
}

// ---- the device ----

const devices = new Newest((request) => engine.call('scan', request), showDevice, fail);
const mostMemory = 1 << 20;
const memoryOf = () => {
  const least = opened.leastMemory ?? 8192;
  return Math.round(least * (Math.max(mostMemory, 4 * least) / least) ** Number(by('memory').value));
};

function askDevice() {
  if (opened?.isVolume) devices.ask({ memory: memoryOf() });
}

/** @param {any} scan */
function showDevice(scan) {
  opened.leastMemory = scan.least;
  opened.scan = scan;
  const seconds = (/** @type {number} */ bytes) => {
    const time = (bytes * 10) / Number(by('baud').value);
    return `${time < 10 ? time.toFixed(1) : whole(time)} s`;
  };
  const length = (/** @type {number} */ bytes) => `${whole(bytes)} bytes, ${seconds(bytes)}`;
  by('memory-text').textContent = `${number(Math.round(memoryOf() / 102.4) / 10)} KiB`;
  by('device-regions').textContent = length(scan.regions.bytes);
  by('device-slices').textContent = length(scan.slices.bytes);
  by('device-pieces').textContent = scan.regions.fragments === 0 ? 'none'
    : `${whole(scan.regions.fragments)}, joined by the receiver`;
}

// ---- measuring ----

/** @param {number} right @param {number} up */
function pick(right, up) {
  if (!by('measure').checked) return;
  const point = view.pick(right, up);
  if (!point) {
    by('distance').textContent = 'There is no surface at this point.';
    return;
  }
  marks = marks.length === 1 ? [marks[0], point] : [point];
  view.setMarks(marks);
  by('distance').textContent = marks.length === 1
    ? `From ${point.map((at) => at.toFixed(1)).join(', ')} mm to …`
    : `${Math.hypot(...marks[1].map((at, i) => at - marks[0][i])).toFixed(2)} mm`;
}

// ---- saving ----

/** @type {Record<string, () => Promise<Blob | null>>} */
const savers = {
  dmc: async () => new Blob([await engine.call('stream', { memory: 64 * mostMemory })]),
  stl: async () => stl(meshOf(view.vertices, view.triangles, opened.spacing)),
  glb: async () => glb(meshOf(view.vertices, view.triangles, opened.spacing)),
  jsonl: async () => jsonl(await engine.call('polygons')),
  png: () => view.picture(),
};

/** @param {string} kind */
async function save(kind) {
  try {
    const blob = await savers[kind]();
    if (!blob) throw new Error('The browser made no picture; try again.');
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    const stem = opened.name.replace(/\.gz$/i, '').replace(/\.[^.]*$/, '');
    link.download = `${stem}${opened.isVolume ? `-${Number(shownIso.toPrecision(6))}` : ''}.${kind}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  } catch (error) {
    fail(/** @type {Error} */ (error));
  }
}

// ---- controls ----

function connect() {
  const on = (/** @type {string} */ id, /** @type {string} */ event, /** @type {(e: any) => void} */ act) =>
    by(id).addEventListener(event, act);
  on('open', 'click', () => by('files').click());
  on('files', 'change', () => {
    open([...by('files').files]);
    by('files').value = '';
  });
  on('error-close', 'click', hideError);
  on('threshold', 'input', () => setThreshold(Number(by('threshold').value)));
  on('threshold-number', 'change', () => {
    const iso = by('threshold-number').valueAsNumber;
    if (Number.isFinite(iso)) setThreshold(iso);
  });
  for (const id of ['filter', 'edges', 'smooth']) on(id, 'change', () => {
    view.hasEdges = by('edges').checked;
    askSurface();
  });
  on('colouring', 'change', () => {
    view.setColouring(Number(by('colouring').value));
    by('legend').hidden = by('colouring').value !== '1';
  });
  on('classic', 'change', () => {
    by('caption-classic').hidden = !by('classic').checked;
    if (!by('classic').checked) return view.setClassic(null);
    tellBusy('Marching Cubes…');
    classics.ask({});
  });
  on('axis', 'change', () => {
    setPlaces();
    askPicture();
  });
  on('place', 'input', () => {
    showPlace();
    askPicture();
  });
  on('cut', 'change', showPlace);
  on('memory', 'input', askDevice);
  on('baud', 'change', () => opened?.scan && showDevice(opened.scan));
  on('measure', 'change', () => {
    by('view').classList.toggle('picks', by('measure').checked);
    by('cross').hidden = !by('measure').checked;
    marks = [];
    view.setMarks(marks);
    by('distance').textContent = by('measure').checked
      ? 'Click on the surface, or press Enter in the view for its middle.' : '';
  });
  for (const button of document.querySelectorAll('[data-save]'))
    button.addEventListener('click', () => save(/** @type {HTMLElement} */ (button).dataset.save));
  by('raw-type').replaceChildren(...sampleTypes.map((type) => new Option(type)));
  navigate(by('view'), view.camera, { changed: () => view.draw(), picked: pick, home: () => view.home() });

  let depth = 0;
  const dropping = (/** @type {number} */ step) => (/** @type {DragEvent} */ event) => {
    event.preventDefault();
    depth += step;
    document.body.classList.toggle('dropping', depth > 0);
  };
  addEventListener('dragenter', dropping(1));
  addEventListener('dragleave', dropping(-1));
  addEventListener('dragover', (event) => event.preventDefault());
  addEventListener('drop', async (event) => {
    dropping(-depth)(event);
    if (event.dataTransfer) open(await droppedFiles(event.dataTransfer));
  });
  addEventListener('resize', () => {
    showHistogram();
    askPicture();
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', showHistogram);
}

async function start() {
  try {
    view = new SurfaceView(by('view'));
    engine = new Engine(by('worker').textContent, await embeddedModule());
    connect();
    const embedded = await embeddedFile();
    if (embedded) await open([embedded.file], undefined, embedded.iso);
    document.body.dataset.ready = '';
  } catch (error) {
    tellError(`The page cannot start: ${/** @type {Error} */ (error).message} ` +
      'It needs a browser of 2023 or later with WebGL 2 and WebAssembly.');
  }
}

start();
