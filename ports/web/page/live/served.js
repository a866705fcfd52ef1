// A file beside the page on its server: discmc view --serve.

/**
 * What arrives, to its end, until the server is gone, or `stop` is signalled.
 * @param {string} source @param {AbortSignal} [stop]
 * @param {(share: number) => void} [notify] called with how much of it is here, 0 to 1, where that is
 *   known
 */
export async function* servedBytes(source, stop, notify = () => {}) {
  const response = await fetch(source, { signal: stop }).catch(() => null);
  if (stop?.aborted) return;
  if (!response?.ok || !response.body)
    throw new Error('The server of this page does not answer; start discmc view --serve again');
  const all = Number(response.headers.get('Content-Length'));
  const reader = response.body.getReader();
  let count = 0;
  for (;;) {
    const { done, value } = await reader.read().catch(() => ({ done: true, value: undefined }));
    if (done || !value) return;
    count += value.length;
    if (all > 0) notify(count / all);
    yield value;
  }
}

/** The whole file. @param {string} name @param {string} source @param {(share: number) => void} notify */
export async function servedWhole(name, source, notify) {
  const pieces = [];
  for await (const piece of servedBytes(source, undefined, notify)) pieces.push(piece);
  return new File(pieces, name);
}
