// What went wrong, and what is under way.
import { by, on } from './elements.js';

/** @param {string} text */
export function tellError(text) {
  by('error-text').textContent = text;
  by('error').hidden = false;
}
export function hideError() {
  by('error').hidden = true;
}
/** @param {string} text empty: nothing is */
export function tellBusy(text) {
  by('busy').textContent = text;
  by('busy').hidden = text === '';
}
/** @param {Error & {isStale?: boolean}} error */
export function fail(error) {
  if (error.isStale) return;
  tellBusy('');
  tellError(error.message);
}

on('error-close', 'click', hideError);
