// The names and colours of the parts of a mesh.
import { by } from '../elements.js';

/** @param {{name: string, colour: number[]}[]} parts of which those without a name are not listed */
export function showLabels(parts) {
  const named = parts.filter(({ name }) => name);
  by('labels').hidden = named.length === 0;
  by('labels').replaceChildren(...named.map(({ name, colour }) => {
    const item = document.createElement('span');
    item.textContent = name;
    item.style.setProperty('--swatch', `rgb(${colour.map((part) => Math.round(255 * part))})`);
    return item;
  }));
}
