// A device on a serial port of this computer.

export const hasSerial = () => 'serial' in navigator;

/**
 * What arrives, until the device is gone or `stop` is signalled. Asks the user for the port: call
 * it for a click.
 * @param {number} baud @param {AbortSignal} stop
 */
export async function serialBytes(baud, stop) {
  const port = await /** @type {any} */ (navigator).serial.requestPort();
  await port.open({ baudRate: baud, bufferSize: 1 << 16 });
  return bytesOf(port, stop);
}

/** @param {any} port @param {AbortSignal} stop */
async function* bytesOf(port, stop) {
  const reader = port.readable.getReader();
  const cancel = () => reader.cancel();
  stop.addEventListener('abort', cancel);
  try {
    for (let read = await reader.read(); !read.done; read = await reader.read()) yield read.value;
  } finally {
    stop.removeEventListener('abort', cancel); // a reader without its lock cannot be cancelled
    reader.releaseLock();
    await port.close();
  }
}
