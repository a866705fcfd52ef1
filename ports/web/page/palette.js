// Colours that people with any colour vision can distinguish: M. Okabe and K. Ito, Color
// Universal Design, 2008.

/** Red, green and blue from 0 to 1. @param {string} hex */
export const rgb = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);

export const orange = '#e69f00';
export const skyBlue = '#56b4e9';
export const green = '#009e73';
export const yellow = '#f0e442';
export const vermilion = '#d55e00';
export const purple = '#cc79a7';

/** The colour of a surface of one colour. */
export const bone = '#e0ba92';
