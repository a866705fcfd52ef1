// A recorded stream as a device would send it: at the pace of its link, and with losses.

const minWait = 50; // milliseconds

/** @param {number} milliseconds @param {AbortSignal} stop */
const pause = (milliseconds, stop) => new Promise((resolve) => {
  setTimeout(resolve, milliseconds);
  stop.addEventListener('abort', resolve);
});

/**
 * The frames of a stream: a frame ends with a zero byte, and there is none in it (lib/WIRE.md).
 * @param {Uint8Array} bytes
 */
function framesOf(bytes) {
  const frames = [];
  for (let begin = 0; begin < bytes.length;) {
    const zero = bytes.indexOf(0, begin);
    const end = zero < 0 ? bytes.length : zero + 1;
    frames.push(bytes.subarray(begin, end));
    begin = end;
  }
  return frames;
}

/**
 * The bytes as they arrive. The first frame, the header, is never lost: without it nothing can be
 * shown.
 * @param {Uint8Array} bytes
 * @param {number} baud bits a second; ten are a byte
 * @param {number} lostShare of the packets, 0 to 1
 * @param {AbortSignal} stop @param {() => number} [chance] 0 to 1
 */
export async function* replayed(bytes, baud, lostShare, stop, chance = Math.random) {
  const begin = performance.now();
  let due = 0; // bytes that the link has carried
  for (const [i, frame] of framesOf(bytes).entries()) {
    due += frame.length;
    const wait = begin + (due * 10000) / baud - performance.now();
    if (wait > minWait) await pause(wait, stop);
    if (stop.aborted) return;
    if (i === 0 || chance() >= lostShare) yield frame;
  }
}
