// Streams while they arrive: from a device, or replayed at its pace.
import { by, on, whole } from '../elements.js';
import { Listener } from '../live/listener.js';
import { replayed } from '../live/replay.js';
import { hasSerial, serialBytes } from '../live/serial.js';
import { servedBytes } from '../live/served.js';
import { fail, hideError, showBusy } from '../messages.js';

export class LivePanel {
  /**
   * @param {import('../engine.js').Engine} engine
   * @param {(name: string, arrived: any, isFirst: boolean, isEnd: boolean) => void} show
   * @param {() => object} wishes how the surface is drawn
   */
  constructor(engine, show, wishes) {
    this.show = show;
    this.listener = new Listener(engine, wishes);
    /** A stream that can be replayed. @type {Blob | null} */
    this.recorded = null;
    this.name = '';
    this.stopping = new AbortController();
    by('connect').hidden = !hasSerial();
    on('connect', 'click', () => by('serial').showModal());
    on('serial', 'close', () => {
      if (by('serial').returnValue === 'connect') this.connect(by('serial-baud').valueAsNumber);
      by('serial').returnValue = '';
    });
    on('replay', 'click', () => this.replay());
    on('stop', 'click', () => this.stopping.abort());
  }

  /** A stream is open that was read whole, or none. @param {string} name @param {Blob | null} stream */
  open(name, stream) {
    this.name = name;
    this.recorded = stream;
    by('replay-row').hidden = stream === null;
  }

  /** The stream that is open; while it arrives, what is here of it. @returns {Blob} */
  stream() {
    return this.recorded ?? new Blob(this.listener.pieces);
  }

  /** Something else is opened. */
  leave() {
    this.listener.leave();
    this.stopping.abort();
    this.showListening(false);
  }

  /** A stream is about to arrive. @returns {AbortSignal} that it is to stop */
  begin() {
    this.leave();
    this.stopping = new AbortController();
    return this.stopping.signal;
  }

  /** @param {number} baud */
  async connect(baud) {
    const signal = this.begin();
    try {
      await this.receive('device', await serialBytes(baud, signal));
    } catch (error) {
      const isRefused = error instanceof DOMException && error.name === 'NotFoundError';
      if (!isRefused) fail(/** @type {Error} */ (error)); // else no port was chosen
    }
  }

  /** A stream that a server has. @param {string} name @param {string} source */
  async fetch(name, source) {
    await this.receive(name, servedBytes(source, this.begin()));
  }

  async replay() {
    if (!this.recorded) return;
    const signal = this.begin();
    try {
      const bytes = new Uint8Array(await this.recorded.arrayBuffer());
      if (signal.aborted) return; // something else was opened meanwhile
      await this.receive(this.name, replayed(bytes, Number(by('replay-baud').value),
        Number(by('replay-lost').value), signal), this.recorded);
    } catch {
      fail(new Error(`${this.name}: the file can no longer be read; open it again`));
    }
  }

  /**
   * Shows what arrives until it ends; then it can be replayed.
   * @param {string} name @param {AsyncIterable<Uint8Array>} source
   * @param {Blob} [recorded] what is replayed
   */
  async receive(name, source, recorded) {
    hideError();
    this.recorded = recorded ?? null;
    this.showListening(true);
    showBusy('Waiting for the stream…');
    let isFirst = true;
    try {
      await this.listener.receive(source, (arrived, isEnd) => {
        if (isEnd) {
          this.showListening(false);
          this.open(name, recorded ?? new Blob(this.listener.pieces));
        }
        if (isEnd && !arrived.stream.hasHeader)
          fail(new Error(`${name}: there is no header of a discmc stream in ${whole(arrived.stream.bytes)} ` +
            'bytes; check the baud rate, and that the device begins a scan'));
        if (!arrived.stream.hasHeader) return;
        showBusy('');
        this.show(name, arrived, isFirst, isEnd);
        isFirst = false;
      });
    } catch (error) {
      this.showListening(false);
      fail(/** @type {Error} */ (error));
    }
  }

  /** @param {boolean} isListening */
  showListening(isListening) {
    by('stop').hidden = !isListening;
    if (isListening) by('replay-row').hidden = true;
  }
}
