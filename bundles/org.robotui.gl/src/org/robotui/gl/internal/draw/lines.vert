// Lines. What is no finite number is put where nothing is seen.
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 color;
uniform mat4 clipFromShape;
uniform vec4 tint;
uniform vec4 glow;
out vec4 shade;

void main() {
  gl_Position = abs(place.x + place.y + place.z) < 1e30 ? clipFromShape * vec4(place, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
  vec4 own = color * tint;
  shade = vec4(mix(own.rgb, glow.rgb, glow.a), own.a);
}
