// The elements of the page, and numbers as it writes them.

/** @param {string} id @returns {any} */
export const by = (id) => document.getElementById(id);

/** @param {string} id @param {string} event @param {(event: any) => void} act */
export const on = (id, event, act) => by(id).addEventListener(event, act);

/** @param {number} value */
export const number = (value) => value.toLocaleString('en', { maximumSignificantDigits: 6 });
/** @param {number} value */
export const whole = (value) => Math.round(value).toLocaleString('en');
/** As in "1 packet" and "2 packets". @param {number} count @param {string} thing */
export const counted = (count, thing) => `${whole(count)} ${thing}${count === 1 ? '' : 's'}`;
