// The mouse, fingers and keys that move the camera.

const keySteps = 0.08;

/**
 * @param {HTMLElement} element
 * @param {import('./camera.js').Camera} camera
 * @param {{changed: () => void, picked: (right: number, up: number) => void,
 *   pointed: (right: number, up: number) => void, home: () => void}} notify
 *   picked: a click, and pointed: a mouse that passes; from -1 to 1 to the right and upwards in the
 *   element
 */
export function navigate(element, camera, notify) {
  /** @type {Map<number, {x: number, y: number}>} */
  const pointers = new Map();
  let travelled = 0;
  const placeOf = (/** @type {PointerEvent} */ event) => {
    const box = element.getBoundingClientRect();
    return /** @type {const} */ ([(2 * (event.clientX - box.left)) / box.width - 1,
      1 - (2 * (event.clientY - box.top)) / box.height]);
  };

  element.addEventListener('pointerdown', (event) => {
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 1) travelled = 0;
  });
  element.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return notify.pointed(...placeOf(event));
    const now = { x: event.clientX, y: event.clientY };
    const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
    const size = Math.min(element.clientWidth, element.clientHeight);
    const right = (now.x - before.x) / size, down = (now.y - before.y) / size;
    travelled += Math.hypot(now.x - before.x, now.y - before.y);
    pointers.set(event.pointerId, now);
    if (other) {
      // Two fingers: each contributes half of the way.
      camera.pan(right / 2, -down / 2);
      const apart = (/** @type {{x: number, y: number}} */ p) =>
        Math.hypot(p.x - other.x, p.y - other.y);
      if (apart(before) > 0) camera.zoom(apart(now) / apart(before));
    } else if (event.buttons === 2 || event.buttons === 4 || event.shiftKey) {
      camera.pan(right, -down);
    } else {
      camera.rotate(right * Math.PI, down * Math.PI);
    }
    notify.changed();
  });
  const release = (/** @type {PointerEvent} */ event) => {
    if (!pointers.delete(event.pointerId)) return;
    const mostOfClick = 4; // pixels
    if (event.type !== 'pointerup' || travelled > mostOfClick || event.button !== 0) return;
    notify.picked(...placeOf(event));
  };
  element.addEventListener('pointerup', release);
  element.addEventListener('pointercancel', release);
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    camera.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)));
    notify.changed();
  }, { passive: false });

  /** @type {Record<string, () => void>} */
  const keys = {
    ArrowLeft: () => camera.rotate(-keySteps, 0),
    ArrowRight: () => camera.rotate(keySteps, 0),
    ArrowUp: () => camera.rotate(0, -keySteps),
    ArrowDown: () => camera.rotate(0, keySteps),
    'shift ArrowLeft': () => camera.pan(-keySteps, 0),
    'shift ArrowRight': () => camera.pan(keySteps, 0),
    'shift ArrowUp': () => camera.pan(0, keySteps),
    'shift ArrowDown': () => camera.pan(0, -keySteps),
    '+': () => camera.zoom(1.15),
    '=': () => camera.zoom(1.15),
    '-': () => camera.zoom(1 / 1.15),
    0: notify.home,
    Home: notify.home,
    Enter: () => notify.picked(0, 0),
  };
  element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const isArrow = event.key.startsWith('Arrow');
    const act = keys[event.shiftKey && isArrow ? `shift ${event.key}` : event.key];
    if (!act) return;
    event.preventDefault();
    act();
    notify.changed();
  });
}
