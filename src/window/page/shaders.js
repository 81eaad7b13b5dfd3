// What the graphics card runs. Points come in steps of the box; palettes are textures of one row
// after the other.

const PALETTE_WIDTH = 1024;

const COMMON = `#version 300 es
precision highp float;
precision highp int;
uniform mat4 matrix;
uniform vec3 scale, shift, eye;
vec4 entry(sampler2D palette, uint i) {
  return texelFetch(palette, ivec2(i % ${PALETTE_WIDTH}u, i / ${PALETTE_WIDTH}u), 0);
}
`;

const SURFACE_VERTEX = COMMON + `
in vec3 point;
in vec4 normal; // and how open the sky is
in uint part;
uniform sampler2D palette;
out vec3 place, direction;
out float open;
flat out vec3 colour;
void main() {
  place = point * scale + shift;
  direction = normal.xyz;
  open = normal.w;
  colour = pow(entry(palette, part).rgb, vec3(2.2));
  gl_Position = matrix * vec4(place, 1.);
}`;

// Smooth where the surface is, flat at its creases; lit from three sides of the eye, darker in cavities
// and towards its outline.
const SURFACE_FRAGMENT = COMMON + `
in vec3 place, direction;
in float open;
flat in vec3 colour;
uniform vec4 cut;
uniform vec3 right, up, back;
uniform float opacity, gain;
uniform bool has_inside;
uniform vec4 ink; // of edges; or its opacity is 0
out vec4 result;
float diffuse(vec3 n, vec3 light) {
  return max(0., (dot(n, light) + .25) / 1.25);
}
void main() {
  if(dot(place, cut.xyz) > cut.w)
    discard;
  if(ink.a > 0.) {
    result = ink;
    return;
  }
  vec3 to_eye = normalize(eye - place);
  vec3 flat_normal = normalize(cross(dFdx(place), dFdy(place)));
  flat_normal *= sign(dot(flat_normal, to_eye));
  vec3 smooth_normal = normalize(direction) * (gl_FrontFacing ? 1. : -1.);
  vec3 n = dot(smooth_normal, flat_normal) > .8 ? smooth_normal : flat_normal;
  vec3 key = normalize(-.45 * right + .65 * up + .75 * back);
  vec3 fill = normalize(.8 * right - .1 * up + .55 * back);
  vec3 rim = normalize(.3 * right + .7 * up - .6 * back);
  bool is_inside = has_inside && !gl_FrontFacing;
  float sky = is_inside ? .6 : open;
  vec3 light = sky * (vec3(.2, .21, .24) + (.5 + .5 * dot(n, up)) * vec3(.13, .14, .16)) +
               (.35 + .65 * sky) * (diffuse(n, key) * vec3(.74, .72, .68) +
                                    diffuse(n, fill) * vec3(.13, .14, .17) + diffuse(n, rim) * vec3(.1));
  float facing = clamp(dot(n, to_eye), 0., 1.), away = 1. - facing;
  vec3 shade = colour * (is_inside ? vec3(.62, .5, .36) : vec3(1.)) * light;
  shade += .1 * sky * pow(max(dot(n, normalize(key + to_eye)), 0.), 40.);
  result = vec4(pow(gain * shade * (.5 + .5 * (1. - away * away * away)), vec3(1. / 2.2)), opacity);
}`;

// A segment as two triangles around it, of constant width in pixels, or as thick as it is; a little
// nearer than it is, so that the surface on which it lies does not hide it. Points are entries of a
// texture: see loadLines(). (Instances would be slow where there is no graphics card.)
const LINE_VERTEX = COMMON + `
precision highp usampler2D;
uniform usampler2D points;
uniform sampler2D palette;
uniform vec2 size;
uniform float width, near;
uniform float thick; // pixels in a step of radii, at the depth 1; or 0
uniform int wanted; // 0: all that is shown, 1: what is lit, 2: numbers in place of colours
flat out vec2 a, b, radii, inverses; // of the depths
flat out vec4 colour;
uvec4 point_at(int i) {
  return texelFetch(points, ivec2(i % ${PALETTE_WIDTH}, i / ${PALETTE_WIDTH}), 0);
}
vec4 seen(vec3 point) {
  return matrix * vec4(mix(point * scale + shift, eye, .0012), 1.);
}
void main() {
  int segment = gl_VertexID / 6, vertex = gl_VertexID % 6;
  uvec4 from = point_at(segment), to = point_at(segment + 1);
  uint owner = from.w >> 1;
  vec4 state = entry(palette, owner);
  bool is_lit = state.a > .9;
  gl_Position = vec4(2., 2., 2., 1.);
  if((from.w & 1u) == 0u || state.a < .1 || wanted == 1 && !is_lit)
    return;
  vec4 p = seen(vec3(from.xyz & 65535u)), q = seen(vec3(to.xyz & 65535u));
  if(p.w < near && q.w < near)
    return;
  if(p.w < near)
    p = mix(p, q, (near - p.w) / (q.w - p.w));
  if(q.w < near)
    q = mix(q, p, (near - q.w) / (p.w - q.w));
  a = (p.xy / p.w * .5 + .5) * size;
  b = (q.xy / q.w * .5 + .5) * size;
  inverses = 1. / vec2(p.w, q.w);
  float thin = .5 * width * float(from.y >> 16) / 16. * (is_lit ? 1.8 : 1.);
  radii = max(vec2(thin), thick * vec2(from.x >> 16, to.x >> 16) * inverses);
  float radius = max(radii.x, radii.y);
  uint number = owner + 1u;
  colour = wanted == 2 ? vec4(number & 255u, number >> 8 & 255u, number >> 16, 255u) / 255.
                       : vec4(state.rgb, 1.);
  vec2 along = length(b - a) > 1e-4 ? normalize(b - a) : vec2(1., 0.);
  vec2 aside = vec2(-along.y, along.x);
  bool is_end = vertex > 1 && vertex != 3, is_left = (vertex & 1) == 0;
  vec2 corner = (is_end ? b : a) + (radius + 1.) * ((is_end ? along : -along) +
                                                    (is_left ? aside : -aside));
  vec4 end = is_end ? q : p;
  gl_Position = vec4((corner / size * 2. - 1.) * end.w, end.zw);
}`;

const LINE_FRAGMENT = COMMON + `
flat in vec2 a, b, radii, inverses;
flat in vec4 colour;
uniform float strength;
uniform int wanted;
uniform float least; // of what it covers of a pixel
uniform vec3 round; // if lines hide each other: the depth is x - y / w, and z pixels are 1
out vec4 result;
void main() {
  vec2 p = gl_FragCoord.xy - a, d = b - a;
  float t = clamp(dot(p, d) / max(dot(d, d), 1e-8), 0., 1.);
  float radius = mix(radii.x, radii.y, t), away = length(p - t * d);
  float cover = clamp(radius + .5 - away, 0., 1.);
  if(cover < least)
    discard;
  float facing = sqrt(max(0., 1. - away * away / (radius * radius)));
  float shade = mix(1., .5 + .5 * facing, smoothstep(2., 6., radius));
  result = wanted == 2 ? vec4(colour.rgb, strength)
                       : vec4(shade * colour.rgb, strength < 1. ? strength : cover);
  gl_FragDepth = gl_FragCoord.z;
  if(round.z > 0.) {
    float depth = 1. / mix(inverses.x, inverses.y, t);
    float front = depth * (1. - .96 * radius * facing / round.z); // it may touch the surface
    gl_FragDepth = .5 + .5 * (round.x - round.y / front);
  }
}`;
