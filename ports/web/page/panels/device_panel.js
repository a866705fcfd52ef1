// What would leave a device that has so much memory.
import { by, number, on, whole } from '../elements.js';
import { Newest } from '../engine.js';
import { fail } from '../messages.js';

const maxBytes = 1 << 20;
const bitsPerByte = 10; // with the start and the stop bit

export class DevicePanel {
  /** @param {import('../engine.js').Engine} engine */
  constructor(engine) {
    this.least = 8192;
    this.devices = new Newest((request) => engine.call('scan', request), (scan) => this.show(scan), fail);
    on('memory', 'input', () => this.ask());
    on('baud', 'change', () => this.scan && this.show(this.scan));
  }

  /** Units: bytes. In equal ratios along the slider. */
  memory() {
    const ratio = Math.max(maxBytes, 4 * this.least) / this.least;
    return Math.round(this.least * ratio ** Number(by('memory').value));
  }

  /** Scans the surface that is there now. */
  ask() {
    this.devices.ask({ memory: this.memory() });
  }

  /** @param {any} scan */
  show(scan) {
    this.scan = scan;
    this.least = scan.least;
    const seconds = (/** @type {number} */ bytes) => {
      const time = (bytes * bitsPerByte) / Number(by('baud').value);
      return `${time < 10 ? time.toFixed(1) : whole(time)} s`;
    };
    const length = (/** @type {number} */ bytes) => `${whole(bytes)} bytes, ${seconds(bytes)}`;
    by('memory-text').textContent = `${number(Math.round(this.memory() / 102.4) / 10)} KiB`;
    by('device-regions').textContent = length(scan.regions.bytes);
    by('device-slices').textContent = length(scan.slices.bytes);
    by('device-fragments').textContent = scan.regions.fragments === 0 ? 'none'
      : `${whole(scan.regions.fragments)}, joined by the receiver`;
  }
}
