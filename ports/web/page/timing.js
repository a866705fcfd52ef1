// How long things took, for whoever observes it: a PerformanceObserver of measures.

/** @param {string} name @param {number} start @param {number} duration @param {object} detail */
export function record(name, start, duration, detail) {
  performance.measure(name, { start, duration, detail });
  performance.clearMeasures(name); // observers have it; kept, they would pile up
}
