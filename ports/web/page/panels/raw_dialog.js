// Asks for the layout of headerless samples.
import { by, whole } from '../elements.js';
import { proposedLayout } from '../formats/raw.js';
import { sampleTypes } from '../formats/volume_info.js';

by('raw-type').replaceChildren(...sampleTypes.map((type) => new Option(type)));

/**
 * @param {{name: string, size: number}} file
 * @returns {Promise<import('../formats/raw.js').RawLayout | null>} nothing if it was cancelled
 */
export function askLayout(file) {
  const dialog = by('raw'), form = by('raw-form').elements;
  const proposed = proposedLayout(file.name, file.size);
  by('raw-text').textContent =
    `${file.name} (${whole(file.size)} bytes) has no header. Enter its layout.`;
  ['x', 'y', 'z'].forEach((axis, i) => (form[axis].value = proposed.dims[i]));
  form.type.value = proposed.type;
  dialog.returnValue = '';
  dialog.showModal();
  const numbers = (/** @type {string[]} */ names) => names.map((name) => Number(form[name].value));
  return new Promise((resolve) => {
    dialog.onclose = () => resolve(dialog.returnValue !== 'open' ? null : {
      dims: /** @type {any} */ (numbers(['x', 'y', 'z'])), type: form.type.value,
      bigEndian: form.big.checked, spacing: /** @type {any} */ (numbers(['dx', 'dy', 'dz'])),
    });
  });
}
