// Saves what is shown as a file.
import { fail } from '../messages.js';
import { glb } from '../save/glb.js';
import { jsonl } from '../save/jsonl.js';
import { meshOf, movedMeshOf } from '../save/mesh.js';
import { stl } from '../save/stl.js';

const enoughMemory = 64 << 20; // for a stream without loose pieces
const kept = 60000; // milliseconds

export class SavePanel {
  /**
   * @param {import('../engine.js').Engine} engine @param {import('../surface_view.js').SurfaceView} view
   * @param {() => string} stem of the file's name
   * @param {() => Blob | null} recorded the stream that is open, if it is one
   */
  constructor(engine, view, stem, recorded) {
    this.stem = stem;
    const mesh = () => (view.isMesh ? movedMeshOf : meshOf)(view.vertices, view.triangles, view.spacing);
    /** @type {Record<string, () => Promise<Blob | null>>} */
    this.writers = {
      dmc: async () =>
        recorded() ?? new Blob([await engine.call('stream', { memory: enoughMemory })]),
      stl: async () => stl(mesh()),
      glb: async () => glb(mesh()),
      jsonl: async () => jsonl(await engine.call('polygons')),
      png: () => view.picture(),
    };
    for (const button of document.querySelectorAll('[data-save]'))
      button.addEventListener('click', () =>
        this.save(/** @type {HTMLElement} */ (button).dataset.save ?? ''));
  }

  /** What a mesh is saved as. @param {boolean} isMesh or else a surface of polygons */
  open(isMesh) {
    for (const button of document.querySelectorAll('[data-save]'))
      /** @type {HTMLElement} */ (button).hidden =
        isMesh && /** @type {HTMLElement} */ (button).dataset.save !== 'png';
  }

  /** @param {string} kind */
  async save(kind) {
    try {
      const blob = await this.writers[kind]();
      if (!blob) throw new Error('The browser could not make the picture; make the window smaller, and try again.');
      const link = document.createElement('a');
      link.href = URL.createObjectURL(blob);
      link.download = `${this.stem()}.${kind}`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), kept);
    } catch (error) {
      fail(/** @type {Error} */ (error));
    }
  }
}
