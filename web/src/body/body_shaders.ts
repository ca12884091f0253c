// One program draws all of the body's view: its surface, rods and arrows, thin circles, and the shadow.

export const vertexShader = `#version 300 es
uniform mat3 shape;
uniform mat3 normals;
uniform vec3 offset;
uniform mat4 camera;
in vec3 place;
in vec3 normal;
out vec3 at;
out vec3 facing;
out vec3 sphere;
void main() {
  at = shape * place + offset;
  facing = normals * normal;
  sphere = place;
  gl_Position = camera * vec4(at, 1.0);
}`;

export const fragmentShader = `#version 300 es
precision highp float;
uniform int kind;       // 0 surface, 1 rod, 2 line, 3 shadow
uniform vec4 colour;
uniform vec3 eye;
uniform mat3 material;  // from the surface's sphere to the material's
uniform mat3 stretch;   // S after the reference body
uniform vec3 reference;
uniform float strain;   // the largest |log stretch|
uniform vec3 longer;
uniform vec3 neutral;
uniform vec3 shorter;
in vec3 at;
in vec3 facing;
in vec3 sphere;
out vec4 pixel;

/// How near to a line of level of a coordinate, 0 ... 1, about one pixel wide.
float line(float value, float width) {
  float d = abs(fract(value - 0.5) - 0.5) / max(fwidth(value), 1e-6);
  return 1.0 - smoothstep(width - 0.5, width + 0.5, d);
}

void main() {
  if (kind == 2) { pixel = vec4(colour.rgb * colour.a, colour.a); return; }
  if (kind == 3) {
    float a = colour.a * exp(-2.2 * dot(sphere.xy, sphere.xy)) ;
    pixel = vec4(colour.rgb * a, a);
    return;
  }
  vec3 n = normalize(facing);
  vec3 look = normalize(eye - at);
  if (dot(n, look) < 0.0) n = -n;
  vec3 base = colour.rgb;
  if (kind == 0) {
    vec3 u = normalize(sphere);
    float s = log(length(stretch * u) / length(reference * u)) / strain;
    base = mix(neutral, s > 0.0 ? longer : shorter, smoothstep(0.0, 1.0, abs(s)));
    vec3 m = material * u;
    float around = atan(m.y, m.x) / 0.52359878;
    float up = asin(clamp(m.z, -1.0, 1.0)) / 0.52359878;
    float ring = length(m.xy);
    float grid = max(line(up, 0.6), ring > 0.12 ? line(around, 0.6) : 0.0);
    float seam = max(max(line(m.x * 4.0, 1.1) * step(abs(m.x), 0.1), line(m.y * 4.0, 1.1) * step(abs(m.y), 0.1)),
                     line(m.z * 4.0, 1.1) * step(abs(m.z), 0.1));
    base = mix(base, base * 0.62, 0.55 * grid);
    base = mix(base, base * 0.38, 0.75 * seam);
  }
  vec3 key = normalize(vec3(-0.35, -0.55, 0.9) + 0.6 * look);
  float diffuse = max(dot(n, key), 0.0);
  float sky = 0.5 + 0.5 * n.z;
  float shine = pow(max(dot(n, normalize(key + look)), 0.0), 48.0);
  float rim = pow(1.0 - max(dot(n, look), 0.0), 3.0);
  vec3 lit = base * (0.34 + 0.18 * sky + 0.46 * diffuse) + vec3(0.16 * shine) + 0.12 * rim * vec3(0.85, 0.93, 1.0);
  pixel = vec4(lit, 1.0);
}`;
