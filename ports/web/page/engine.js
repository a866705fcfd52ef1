// The worker as promises.

/** An answer of the worker that is none: its message is for the user. */
export class EngineError extends Error {
  /** @param {{message?: string, isStale?: boolean, unknownLayout?: {name: string, size: number}}} answer */
  constructor(answer) {
    super(answer.message ?? '');
    this.unknownLayout = answer.unknownLayout;
    /** Something else was opened meanwhile: no message is needed. */
    this.isStale = answer.isStale;
  }
}

export class Engine {
  /** @param {string} script of the worker @param {Uint8Array} module of WebAssembly */
  constructor(script, module) {
    const url = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
    this.worker = new Worker(url);
    /** @type {Map<number, {resolve: (result: any) => void, reject: (error: Error) => void}>} */
    this.waiting = new Map();
    this.count = 0;
    this.opened = 0; // what requests are about, as the worker counts it
    this.worker.onmessage = ({ data: { id, opened, result, error } }) => {
      this.opened = opened;
      const call = this.waiting.get(id);
      this.waiting.delete(id);
      if (error) call?.reject(new EngineError(error));
      else call?.resolve(result);
    };
    this.call('start', { bytes: module });
  }

  /** @param {string} call @param {object} [request] @returns {Promise<any>} */
  call(call, request = {}) {
    return new Promise((resolve, reject) => {
      const id = ++this.count;
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, call, opened: this.opened, ...request });
    });
  }
}

/**
 * Calls with the newest request alone: while one is under way the next waits, and one that comes
 * later takes its place. So what is shown keeps up with a slider.
 */
export class Newest {
  /**
   * @template Request, Result
   * @param {(request: any) => Promise<any>} call
   * @param {(result: any) => void} show
   * @param {(error: Error) => void} fail
   */
  constructor(call, show, fail) {
    this.call = call;
    this.show = show;
    this.fail = fail;
    this.isBusy = false;
    /** @type {any} */
    this.wanted = null;
  }

  /** @param {any} request */
  ask(request) {
    this.wanted = request;
    if (!this.isBusy) this.begin();
  }

  async begin() {
    this.isBusy = true;
    let call = this.next();
    while (call) {
      try {
        const result = await call;
        call = this.next(); // under way while this one is shown
        this.show(result);
      } catch (error) {
        call = this.next();
        this.fail(/** @type {Error} */ (error));
      }
    }
    this.isBusy = false;
  }

  next() {
    const request = this.wanted;
    this.wanted = null;
    return request === null ? null : this.call(request);
  }
}
