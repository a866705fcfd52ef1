// The sizes of a scan, as capacities.hpp and slice_encoder.hpp work them out, and the form that shows
// them. A script of its own page, without modules, so that it works from a file.

/** What fits, and what is needed. Units: bytes; indexBytes: 2 or 4. */
function sizesOf(width, height, memory, indexBytes) {
  const leastSlots = 4;
  const mostSlots = indexBytes === 2 ? 32759 : 2147483639;
  const slotBytes = indexBytes === 2 ? 8 : 16;
  const rowBytes = 4 * (Math.floor(width / 30) + 1);
  const alignment = 3;
  const holeLists = indexBytes === 2 ? 32 : 0;
  const fixed = rowBytes * (2 * height + 4) + 288 * indexBytes + holeLists + alignment;
  const minimum = fixed + leastSlots * slotBytes;
  const spare = Math.max(0, Math.min(memory - minimum - 4, 0xffffffff));
  const slots = leastSlots + Math.min(Math.floor(spare / slotBytes), mostSlots - leastSlots);
  const slices = (rows) => rowBytes * (rows + 1) + 548 + alignment;
  return {
    minimum,
    slots,
    holes: Math.floor(slots / 16),
    used: fixed + slots * slotBytes,
    slices: slices(Math.max(height + 2, 4)),
    keySlices: slices(4),
  };
}

/** Bytes of a stream, as a rule of thumb: bits a voxel of a CT head, and of its slices. */
function streamBytes(voxels) {
  return { regions: Math.round(0.027 * voxels), slices: Math.round(0.003 * voxels) };
}

function connectCalculator(form) {
  const grouped = (value) => Math.round(value).toLocaleString('en-US');
  const show = () => {
    const of = (name) => Number(form.elements[name].value);
    const { minimum, slots, holes, used, slices, keySlices } =
      sizesOf(of('width'), of('height'), of('memory'), of('index'));
    const stream = streamBytes(of('width') * of('height') * of('depth'));
    const line = (bytes) => `${grouped(bytes)} bytes, ${(bytes * 10 / of('baud')).toPrecision(3)} s`;
    const fits = of('memory') >= minimum;
    const lines = {
      minimum: `${grouped(minimum)} bytes`,
      slots: fits ? `${grouped(slots)}, of them ${grouped(holes)} for holes; ${grouped(used)} bytes`
        : 'too little memory for regions',
      slices: `${grouped(slices)} bytes`,
      keySlices: `${grouped(keySlices)} bytes`,
      regionsLine: line(stream.regions),
      slicesLine: line(stream.slices),
    };
    for (const [name, text] of Object.entries(lines)) form.elements[name].value = text;
  };
  form.addEventListener('input', () => { if (form.checkValidity()) show(); });
  form.addEventListener('submit', (event) => event.preventDefault());
  show();
}

if (typeof document !== 'undefined') connectCalculator(document.getElementById('calculator-form'));
