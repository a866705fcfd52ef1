// Shows a stream while it arrives.

const minPause = 300; // milliseconds from picture to picture

export class Listener {
  /**
   * @param {import('../engine.js').Engine} engine
   * @param {() => object} wishes how the surface is drawn, as the worker has them
   */
  constructor(engine, wishes) {
    this.engine = engine;
    this.wishes = wishes;
    /** What arrived. @type {Uint8Array[]} */
    this.pieces = [];
    this.turn = 0;
    this.passed = 0; // of the pieces
    this.next = 0; // when a picture is due
  }

  /**
   * Reads to the end of the bytes, or until leave().
   * @param {AsyncIterable<Uint8Array>} source
   * @param {(arrived: {stream: any, surface: any}, isEnd: boolean) => void} show
   */
  async receive(source, show) {
    const turn = ++this.turn;
    this.pieces = [];
    await this.engine.call('listen');
    /** @type {Promise<void> | null} */
    let passing = null;
    /** @type {Error | null} */
    let failure = null;
    const pass = () => this.pass(turn, show).catch((error) => (failure = error)).finally(() => (passing = null));
    this.passed = this.next = 0;
    for await (const bytes of source) {
      if (this.turn !== turn) return;
      if (failure) throw failure;
      this.pieces.push(bytes);
      passing ??= pass();
    }
    await passing;
    if (failure) throw failure;
    if (this.turn === turn) show(await this.arrived(true), true);
  }

  /**
   * Passes on all that arrives meanwhile, and shows it now and then. Half of the time is for what arrives.
   * @param {number} turn @param {(arrived: any, isEnd: boolean) => void} show
   */
  async pass(turn, show) {
    while (this.turn === turn && this.passed < this.pieces.length) {
      const pieces = this.pieces.slice(this.passed);
      this.passed += pieces.length;
      const bytes = new Uint8Array(await new Blob(pieces).arrayBuffer());
      await this.engine.call('receive', { bytes });
      const begin = performance.now();
      if (this.turn !== turn || begin < this.next) continue;
      const arrived = await this.arrived(false);
      if (this.turn === turn) show(arrived, false);
      this.next = performance.now() + Math.max(minPause, performance.now() - begin);
    }
  }

  /** @param {boolean} isEnd */
  arrived(isEnd) {
    return this.engine.call('arrived', { isEnd, ...this.wishes() });
  }

  /** The engine is for something else from here on. */
  leave() {
    ++this.turn;
  }
}
