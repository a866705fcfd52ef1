// How the surface of a stream is drawn.

/**
 * The merged polygons, or a mesh as discmc decode --surface makes it.
 * @typedef {'polygons' | 'relaxed' | 'interpolated'} Shape
 */

/** The one that is nearest to the samples. @param {number} levels of the fractions; 0: there are none */
export const bestShape = (levels) => /** @type {Shape} */ (levels > 0 ? 'interpolated' : 'polygons');
