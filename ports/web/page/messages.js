// Messages: errors, and work in progress.
import { by, on } from './elements.js';

/** @param {string} text */
export function showError(text) {
  by('error-text').textContent = text;
  by('error').hidden = false;
}
export function hideError() {
  by('error').hidden = true;
}
/** @param {string} text empty: hides it */
export function showBusy(text) {
  by('busy').textContent = text;
  by('busy').hidden = text === '';
}
/** @param {Error & {isStale?: boolean}} error */
export function fail(error) {
  if (error.isStale) return;
  showBusy('');
  showError(error.message);
}

on('error-close', 'click', hideError);
