// Where the viewer is: on a sphere around a point, looking at it. Units: millimetres.
import { Camera as Lens, Vec3 } from 'ogl';

/** Directions that nothing is known of. */
export const asTheyAre = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

const fieldOfView = 35; // degrees, across the smaller side

export class Camera {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.lens = new Lens(gl);
    /** How far from the origin there is something. Units: millimetres. */
    this.depth = 1;
    /** The directions of space: the last one is up. */
    this.upright = asTheyAre;
    this.reset(1, [0, 0, 0]);
  }

  /**
   * Shows a sphere, from before, above and a bit to the left.
   * @param {number} radius @param {number[]} target its centre
   */
  reset(radius, target) {
    this.radius = radius;
    this.distance = (1.02 * radius) / Math.sin((fieldOfView / 2) * (Math.PI / 180));
    this.azimuth = Math.atan2(-1.6, -0.9);
    this.elevation = Math.atan2(0.8, Math.hypot(0.9, 1.6));
    this.target = new Vec3(...target);
  }

  /** Also over the poles. Units: radians. @param {number} right @param {number} up */
  rotate(right, up) {
    this.azimuth -= Math.cos(this.elevation) < 0 ? -right : right;
    this.elevation += up;
  }

  /** Units: shares of the picture's smaller side. @param {number} right @param {number} up */
  pan(right, up) {
    const { x, y } = this.axes();
    const step = this.millimetres();
    for (let i = 0; i < 3; ++i) this.target[i] -= step * (right * x[i] + up * y[i]);
  }

  /** @param {number} factor above 1: nearer */
  zoom(factor) {
    const nearest = this.radius / 200;
    this.distance = Math.min(20 * this.radius, Math.max(nearest, this.distance / factor));
  }

  /** Right, upwards and towards the viewer. */
  axes() {
    const [c, s] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    const turned = (/** @type {number[]} */ v) => [0, 1, 2].map((i) =>
      v.reduce((sum, part, j) => sum + part * this.upright[j][i], 0));
    return { x: turned([-s, c, 0]), y: turned([-se * c, -se * s, ce]), z: turned([ce * c, ce * s, se]) };
  }

  /** How many millimetres a share of the picture's smaller side is, in the middle. */
  millimetres() {
    return 2 * this.distance * Math.tan((fieldOfView / 2) * (Math.PI / 180));
  }

  position() {
    const { z } = this.axes();
    return z.map((towards, i) => this.target[i] + this.distance * towards);
  }

  /** The lens for a picture of this shape. @param {number} width @param {number} height */
  lensFor(width, height) {
    const half = Math.tan((fieldOfView / 2) * (Math.PI / 180));
    const upright = width < height ? (half * height) / width : half;
    const [x, y, z] = this.position();
    const away = Math.hypot(x, y, z);
    this.lens.up = new Vec3(...this.axes().y);
    this.lens.perspective({
      fov: (2 * Math.atan(upright) * 180) / Math.PI,
      aspect: width / height,
      near: Math.max(this.distance / 100, away - this.depth),
      far: away + this.depth,
    });
    this.lens.position.set(x, y, z);
    this.lens.lookAt(this.target);
    this.lens.updateMatrixWorld();
    return this.lens;
  }

  /**
   * The line of sight through a point of the picture, from -1 to 1 to the right and upwards.
   * @param {number} right @param {number} up @param {number} width @param {number} height
   */
  ray(right, up, width, height) {
    const { x, y, z } = this.axes();
    const half = Math.tan((fieldOfView / 2) * (Math.PI / 180)) / Math.min(width, height);
    const direction = z.map((towards, i) =>
      right * half * width * x[i] + up * half * height * y[i] - towards);
    return { origin: this.position(), direction };
  }
}
