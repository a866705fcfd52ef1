// Bytes of files as they come: never a whole file in memory.

/** A stream of bytes that can be read piece by piece. */
export class ByteSource {
  /** @param {ReadableStream<Uint8Array>} stream */
  constructor(stream) {
    this.reader = stream.getReader();
    this.held = new Uint8Array(0);
  }

  /** Up to `count` of the next bytes, without consuming them. @param {number} count */
  async peek(count) {
    while (this.held.length < count && (await this.hold()));
    return this.held.subarray(0, count);
  }

  /** Drops bytes; returns how many there were. @param {number} count */
  async skip(count) {
    let dropped = 0;
    while (dropped < count) {
      if (this.held.length === 0 && !(await this.hold())) break;
      const taken = Math.min(count - dropped, this.held.length);
      this.held = this.held.subarray(taken);
      dropped += taken;
    }
    return dropped;
  }

  /** Fills memory with the next bytes; returns how many there were. @param {Uint8Array} target */
  async fill(target) {
    let filled = 0;
    while (filled < target.length) {
      if (this.held.length === 0 && !(await this.hold())) break;
      const taken = Math.min(target.length - filled, this.held.length);
      target.set(this.held.subarray(0, taken), filled);
      this.held = this.held.subarray(taken);
      filled += taken;
    }
    return filled;
  }

  /** The next piece, of any size; null at the end. */
  async next() {
    if (this.held.length === 0 && !(await this.hold())) return null;
    const piece = this.held;
    this.held = new Uint8Array(0);
    return piece;
  }

  /** What has not been read, as a stream. */
  rest() {
    return new ReadableStream({
      pull: async (controller) => {
        const piece = await this.next();
        if (piece) controller.enqueue(piece);
        else controller.close();
      },
      cancel: () => this.reader.cancel(),
    });
  }

  cancel() {
    this.reader.cancel().catch(() => {});
  }

  async hold() {
    const { done, value } = await this.reader.read();
    if (done) return false;
    if (this.held.length === 0) {
      this.held = value;
    } else {
      const joined = new Uint8Array(this.held.length + value.length);
      joined.set(this.held);
      joined.set(value, this.held.length);
      this.held = joined;
    }
    return true;
  }
}

/**
 * @param {ByteSource} source of packed bytes
 * @param {CompressionFormat} format 'gzip', or 'deflate' with the header of zlib
 */
export function inflated(source, format) {
  return new ByteSource(source.rest().pipeThrough(new DecompressionStream(format)));
}

/** Unpacked if they begin like gzip. @param {ByteSource} source */
export async function unpacked(source) {
  const head = await source.peek(2);
  return head[0] === 0x1f && head[1] === 0x8b ? inflated(source, 'gzip') : source;
}

/** Opens a file, unpacked if it is packed. @param {Blob} file */
export const openBytes = (file) => unpacked(new ByteSource(file.stream()));

/** Limit: what matters is ASCII. @param {Uint8Array} bytes */
export const asText = (bytes) => new TextDecoder('latin1').decode(bytes);

/** In place. Limit: aligned as samples of this size are. @param {Uint8Array} bytes @param {number} size */
export function swapBytes(bytes, size) {
  if (size === 2) {
    const samples = new Uint16Array(bytes.buffer, bytes.byteOffset, bytes.length / 2);
    for (let i = 0; i < samples.length; ++i) samples[i] = (samples[i] << 8) | (samples[i] >> 8);
  } else if (size > 2) {
    for (let i = 0; i < bytes.length; i += size) bytes.subarray(i, i + size).reverse();
  }
}
