// What the page has inside: the module, and data that opens at once if there is some, or where it is
// served.

/** @param {string} id of a script element with base64 @param {CompressionFormat} [encoding] */
async function bytesIn(id, encoding) {
  const text = document.getElementById(id)?.textContent?.trim();
  if (!text) return null;
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  if (!encoding) return bytes;
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(encoding));
  return new Uint8Array(await new Response(unpacked).arrayBuffer());
}

/** The module of WebAssembly. */
export async function embeddedModule() {
  const bytes = await bytesIn('module', 'deflate');
  if (!bytes) throw new Error('The WebAssembly module is missing; rebuild discmc.html.');
  return bytes;
}

/** The attributes of the element `data` for a file that is served: data-name, data-source, data-live. */
export function servedFile() {
  const data = document.getElementById('data')?.dataset;
  if (data?.source === undefined) return null;
  return { name: data.name ?? 'volume', source: data.source, isLive: data.live !== undefined };
}

/** A file that the element `data` holds: data-name, data-encoding (gzip, deflate or none), data-iso. */
export async function embeddedFile() {
  const data = document.getElementById('data')?.dataset;
  const bytes = data && (await bytesIn('data', /** @type {any} */ (data.encoding)));
  if (!bytes) return null;
  return {
    file: new File([bytes], data.name ?? 'volume'),
    iso: data.iso === undefined ? undefined : Number(data.iso),
  };
}
