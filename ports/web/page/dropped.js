// Files that are dropped on the page, those in folders too.

/** @param {(files: File[]) => void} take */
export function takeDropped(take) {
  let depth = 0; // of elements that the pointer is over
  const over = (/** @type {number} */ step) => (/** @type {DragEvent} */ event) => {
    event.preventDefault();
    depth += step;
    document.body.classList.toggle('dropping', depth > 0);
  };
  addEventListener('dragenter', over(1));
  addEventListener('dragleave', over(-1));
  addEventListener('dragover', (event) => event.preventDefault());
  addEventListener('drop', async (event) => {
    over(-depth)(event);
    if (event.dataTransfer) take(await filesOfAll(event.dataTransfer));
  });
}

/** @param {DataTransfer} transfer @returns {Promise<File[]>} */
async function filesOfAll(transfer) {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (entries.length === 0) return [...transfer.files];
  const files = await Promise.all(entries.map((entry) => filesOf(/** @type {any} */ (entry))));
  return files.flat();
}

/** @param {any} entry @returns {Promise<File[]>} */
async function filesOf(entry) {
  if (entry.isFile)
    return [await new Promise((resolve, reject) => entry.file(resolve, reject))];
  const reader = entry.createReader();
  const files = [];
  for (;;) {
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return files;
    for (const each of some) files.push(...(await filesOf(each)));
  }
}
