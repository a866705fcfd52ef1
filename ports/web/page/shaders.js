// What the graphics card does with surfaces and lines.

/** Of merged polygons: flat by their incidence, or smooth by told normals. */
export const surfaceVertex = `#version 300 es
precision highp float;
in vec3 position;          // half-steps
in vec2 look;              // incidence, colour number
in vec2 octahedral;        // a normal, or 0
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 toView;       // directions
uniform vec3 spacing;      // millimetres, signed
uniform int colouring;     // 0 plain, 1 kind of plane, 2 polygon
uniform vec3 plain;
uniform vec3 palette[7];
out vec3 normal;
out vec3 place;
out vec3 colour;

// As normal.hpp unfolds it.
vec3 unfolded(vec2 told) {
  vec2 at = (told - 128.0) / 127.0;
  float z = 1.0 - abs(at.x) - abs(at.y);
  vec2 side = vec2(at.x < 0.0 ? -1.0 : 1.0, at.y < 0.0 ? -1.0 : 1.0);
  if (z < 0.0) at = (1.0 - abs(at.yx)) * side;
  return normalize(vec3(at, z));
}

void main() {
  int incidence = int(look.x);
  ivec3 lattice = ivec3(incidence % 3, incidence / 3 % 3, incidence / 9) - 1;
  vec3 flatNormal = normalize(vec3(lattice) / spacing);
  vec3 own = flatNormal;
  if (octahedral.x > 0.0) {
    vec3 smoothNormal = unfolded(octahedral);
    const float steepest = 0.309; // 72 degrees: there is an edge
    if (dot(smoothNormal, flatNormal) > steepest) own = smoothNormal;
  }
  normal = toView * own;
  place = position;
  int kind = abs(lattice.x) + abs(lattice.y) + abs(lattice.z) - 1;
  colour = colouring == 0 ? plain : palette[colouring == 1 ? kind : int(look.y) % 7];
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// A place in half-steps: what lies beyond the cut is left out. Without a cut there is no code for
// it, which graphics cards draw faster.
const cutting = (/** @type {boolean} */ isCut) => (isCut ? `
uniform vec4 cut;
in vec3 place;
void leaveOut() {
  if (dot(cut.xyz, place) > cut.w) discard;
}` : `
void leaveOut() {}`);

const light = `
uniform bool isMirrored;
out vec4 pixel;

// As ports/command/pictures/shading.cpp: a key light over the left shoulder, and a cool fill.
vec3 lit(vec3 base, vec3 normal, bool isInside) {
  vec3 n = normalize(normal) * (isInside ? -1.0 : 1.0);
  float fill = 0.14 + 0.08 * n.y;
  float light = 0.28 * max(0.0, n.z) + 0.74 * max(0.0, dot(n, normalize(vec3(-0.6, 0.7, 0.5))));
  vec3 tone = isInside ? vec3(0.3, 0.6, 1.2) : vec3(1.0);
  vec3 linear = pow(base, vec3(2.2)) * tone * (fill * vec3(0.7, 0.95, 1.4) + light);
  return pow(min(linear, 1.0), vec3(1.0 / 2.2));
}
`;

export const surfaceFragment = (/** @type {boolean} */ isCut) => `#version 300 es
precision highp float;
${cutting(isCut)}
${light}
in vec3 normal;
in vec3 colour;
void main() {
  leaveOut();
  pixel = vec4(lit(colour, normal, gl_FrontFacing == isMirrored), 1.0);
}`;

/** Of triangles that are each flat. */
export const classicVertex = `#version 300 es
precision highp float;
in vec3 position;          // millimetres
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec3 spacing;
out vec3 place;
out vec3 seen;
void main() {
  vec4 at = modelViewMatrix * vec4(position, 1.0);
  seen = at.xyz;
  place = 2.0 * position / spacing;
  gl_Position = projectionMatrix * at;
}`;

export const classicFragment = (/** @type {boolean} */ isCut) => `#version 300 es
precision highp float;
${cutting(isCut)}
${light}
uniform vec3 plain;
in vec3 seen;
void main() {
  leaveOut();
  vec3 towards = normalize(cross(dFdx(seen), dFdy(seen)));
  bool isInside = !gl_FrontFacing;
  pixel = vec4(lit(plain, isInside ? -towards : towards, isInside), 1.0);
}`;

const lines = (/** @type {string} */ toHalfSteps) => `#version 300 es
precision highp float;
in vec3 position;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec3 toPlace;
out vec3 place;
void main() {
  place = position${toHalfSteps};
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
/** Of polygons, in half-steps; and of what is in millimetres. */
export const edgeVertex = lines('');
export const lineVertex = lines(' * toPlace');

export const lineFragment = (/** @type {boolean} */ isCut) => `#version 300 es
precision highp float;
${cutting(isCut)}
uniform vec4 line;         // colour, opacity
out vec4 pixel;
void main() {
  leaveOut();
  pixel = vec4(line.rgb * line.a, line.a);
}`;
