// Shows a stream while it arrives.

const leastPause = 300; // milliseconds from picture to picture

export class Listener {
  /**
   * @param {import('../engine.js').Engine} engine
   * @param {() => boolean} hasEdges whether edges are shown
   */
  constructor(engine, hasEdges) {
    this.engine = engine;
    this.hasEdges = hasEdges;
    /** What arrived. @type {Uint8Array[]} */
    this.pieces = [];
    this.turn = 0;
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
    let next = 0;
    for await (const bytes of source) {
      if (this.turn !== turn) return;
      this.pieces.push(bytes);
      await this.engine.call('receive', { bytes });
      if (this.turn !== turn) return;
      if (performance.now() < next) continue;
      show(await this.arrived(false), false);
      next = performance.now() + leastPause;
    }
    if (this.turn === turn) show(await this.arrived(true), true);
  }

  /** @param {boolean} isEnd */
  arrived(isEnd) {
    return this.engine.call('arrived', { isEnd, hasEdges: this.hasEdges() });
  }

  /** The engine is for something else from here on. */
  leave() {
    ++this.turn;
  }
}
