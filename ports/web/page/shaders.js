// What the graphics card does with surfaces and lines.

/**
 * A vertex of polygons is four 16-bit numbers, fetched as fractions of this, which cards do at once. They are its place
 * in half-steps, and its incidence with 256 times its colour number.
 */
export const vertexUnit = 32767;
const unpacking = `
const float unit = ${vertexUnit}.0;
in vec4 position;
vec3 halfSteps() { return position.xyz * unit; }
int look() { return int(position.w * unit + 0.5); }
int incidence() { return look() & 255; }
int colourNumber() { return look() >> 8; }
`;

// If the inside is seen, what lies beyond a cut is left out. Only the outside of closed surfaces without a cut is
// drawn: without code for the rest they are drawn faster.
const cutting = (/** @type {boolean} */ isOpen) => (isOpen ? `
uniform vec4 cut;          // half-steps
in vec3 place;
void leaveOut() {
  if (dot(cut.xyz, place) > cut.w) discard;
}` : `
void leaveOut() {}`);

/**
 * For merged polygons, each flat. The light on a plane is the same all over it, so it comes with the incidence. Nothing
 * is left to do for a pixel.
 */
export const flatVertex = (/** @type {boolean} */ isOpen) => `#version 300 es
precision highp float;
${unpacking}
uniform mat4 toClip;
uniform vec3 outer[27], inner[27];
uniform vec3 tints[7];
out vec3 outside;
${isOpen ? 'out vec3 inside, place;' : ''}
void main() {
  vec3 tint = tints[colourNumber()];
  outside = outer[incidence()] * tint;
  ${isOpen ? 'inside = inner[incidence()] * tint; place = halfSteps();' : ''}
  gl_Position = toClip * vec4(position.xyz, 1.0);
}`;

export const flatFragment = (/** @type {boolean} */ isOpen) => `#version 300 es
precision highp float;
${cutting(isOpen)}
in vec3 outside;
${isOpen ? 'in vec3 inside; uniform bool isMirrored;' : ''}
out vec4 pixel;
void main() {
  leaveOut();
  pixel = vec4(${isOpen ? 'gl_FrontFacing == isMirrored ? inside : ' : ''}outside, 1.0);
}`;

// As light.js.
const light = `
out vec4 pixel;

vec3 lit(vec3 base, vec3 normal, bool isInside) {
  vec3 n = normalize(normal) * (isInside ? -1.0 : 1.0);
  float fill = 0.14 + 0.08 * n.y;
  float light = 0.28 * max(0.0, n.z) + 0.74 * max(0.0, dot(n, normalize(vec3(-0.6, 0.7, 0.5))));
  vec3 tone = isInside ? vec3(0.3, 0.6, 1.2) : vec3(1.0);
  vec3 linear = pow(base, vec3(2.2)) * tone * (fill * vec3(0.7, 0.95, 1.4) + light);
  return pow(min(linear, 1.0), vec3(1.0 / 2.2));
}
`;

/** For merged polygons, smooth by their packed normals. */
export const smoothVertex = `#version 300 es
precision highp float;
${unpacking}
in vec2 octahedral;        // a normal in 255ths, or 0
uniform mat4 toClip;
uniform mat3 toView;       // directions
uniform vec3 planes[27];   // normals
uniform vec3 bases[27];
uniform vec3 tints[7];
out vec3 normal;
out vec3 place;
out vec3 colour;

// As normal.hpp unfolds it.
vec3 unfolded(vec2 packed) {
  vec2 at = (packed * 255.0 - 128.0) / 127.0;
  float z = 1.0 - abs(at.x) - abs(at.y);
  vec2 side = vec2(at.x < 0.0 ? -1.0 : 1.0, at.y < 0.0 ? -1.0 : 1.0);
  if (z < 0.0) at = (1.0 - abs(at.yx)) * side;
  return normalize(vec3(at, z));
}

void main() {
  vec3 own = planes[incidence()];
  if (octahedral.x > 0.0) {
    vec3 smooth_normal = unfolded(octahedral);
    const float steepest = 0.309; // 72 degrees: there is an edge
    if (dot(smooth_normal, own) > steepest) own = smooth_normal;
  }
  normal = toView * own;
  place = halfSteps();
  colour = bases[incidence()] * tints[colourNumber()];
  gl_Position = toClip * vec4(position.xyz, 1.0);
}`;

export const smoothFragment = (/** @type {boolean} */ isOpen) => `#version 300 es
precision highp float;
${cutting(isOpen)}
${light}
uniform bool isMirrored;
in vec3 normal;
in vec3 colour;
void main() {
  leaveOut();
  pixel = vec4(lit(colour, normal, ${isOpen ? 'gl_FrontFacing == isMirrored' : 'false'}), 1.0);
}`;

// Outwards; seen: the place, as the viewer sees it.
const normalOfTriangle = `
vec3 normalOfTriangle(vec3 seen, bool isInside) {
  vec3 towards = normalize(cross(dFdx(seen), dFdy(seen)));
  return isInside ? -towards : towards;
}`;

/** For a mesh, in half-steps; with its normals, or each triangle flat. */
export const meshVertex = `#version 300 es
precision highp float;
in vec3 position, normal;
in vec4 colour;
uniform mat4 toClip, modelViewMatrix;
uniform mat3 toView;       // directions
out vec3 place, seen, smoothly, base;
void main() {
  seen = (modelViewMatrix * vec4(position, 1.0)).xyz;
  smoothly = toView * normal;
  place = position;
  base = colour.rgb;
  gl_Position = toClip * vec4(position, 1.0);
}`;

export const meshFragment = (/** @type {boolean} */ isOpen) => `#version 300 es
precision highp float;
${cutting(isOpen)}
${light}
${normalOfTriangle}
uniform bool isFlat, isMirrored;
in vec3 seen, smoothly, base;
void main() {
  leaveOut();
  bool isInside = ${isOpen ? 'gl_FrontFacing == isMirrored' : 'false'};
  vec3 flatly = normalOfTriangle(seen, isInside);
  bool hasNormal = !isFlat && dot(smoothly, smoothly) > 0.0;
  pixel = vec4(lit(base, hasNormal ? smoothly : flatly, isInside), 1.0);
}`;

/** For triangles that are each flat, in millimetres. */
export const classicVertex = `#version 300 es
precision highp float;
in vec3 position;
uniform mat4 toClip, modelViewMatrix;
uniform vec3 toPlace;
out vec3 place;
out vec3 seen;
void main() {
  seen = (modelViewMatrix * vec4(position, 1.0)).xyz;
  place = position * toPlace;
  gl_Position = toClip * vec4(position, 1.0);
}`;

export const classicFragment = (/** @type {boolean} */ isOpen) => `#version 300 es
precision highp float;
${cutting(isOpen)}
${light}
${normalOfTriangle}
uniform vec3 plain;
in vec3 seen;
void main() {
  leaveOut();
  pixel = vec4(lit(plain, normalOfTriangle(seen, !gl_FrontFacing), !gl_FrontFacing), 1.0);
}`;

const lines = (/** @type {string} */ toHalfSteps) => `#version 300 es
precision highp float;
in vec3 position;
uniform mat4 toClip;
uniform vec3 toPlace;
out vec3 place;
void main() {
  place = position${toHalfSteps};
  gl_Position = toClip * vec4(position, 1.0);
}`;
/** For polygons; for a mesh; and for vertices in millimetres. */
export const edgeVertex = lines(` * ${vertexUnit}.0`);
export const meshEdgeVertex = lines('');
export const lineVertex = lines(' * toPlace');

/**
 * For lines of some width, each a strip of two triangles: `corner` is the number of its end, and on which side. In
 * half-steps.
 */
export const wideLineVertex = `#version 300 es
precision highp float;
in vec2 corner;            // 0 or 1; -1 or 1
in vec3 from, to;
uniform mat4 toClip;
uniform vec2 halfWidth;    // in shares of half the picture
out vec3 place;
void main() {
  vec4 a = toClip * vec4(from, 1.0), b = toClip * vec4(to, 1.0);
  vec2 way = (b.xy / b.w - a.xy / a.w) / halfWidth;
  vec2 along = dot(way, way) > 0.0 ? normalize(way) : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x) * corner.y + along * (2.0 * corner.x - 1.0);
  place = mix(from, to, corner.x);
  gl_Position = mix(a, b, corner.x);
  gl_Position.xy += across * halfWidth * gl_Position.w;
}`;

export const lineFragment = (/** @type {boolean} */ isOpen) => `#version 300 es
precision highp float;
${cutting(isOpen)}
uniform vec4 line;         // colour, opacity
out vec4 pixel;
void main() {
  leaveOut();
  pixel = vec4(line.rgb * line.a, line.a);
}`;
