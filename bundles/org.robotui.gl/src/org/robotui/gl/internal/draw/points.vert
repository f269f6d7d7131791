// Points: squares of some pixels, or as large as so many metres look. What is no finite number is put where nothing is seen.
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 color;
uniform mat4 clipFromShape;
#ifdef METRES
uniform float reach;
#endif
#ifdef PICK
flat out uint element;
#else
uniform vec4 tint;
uniform vec4 glow;
out vec4 shade;
#endif

void main() {
  gl_Position = abs(place.x + place.y + place.z) < 1e30 ? clipFromShape * vec4(place, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
#ifdef METRES
  gl_PointSize = max(reach / gl_Position.w, 1.0);
#endif
#ifdef PICK
  element = uint(gl_VertexID);
#else
  vec4 own = color * tint;
  shade = vec4(mix(own.rgb, glow.rgb, glow.a), own.a);
#endif
}
