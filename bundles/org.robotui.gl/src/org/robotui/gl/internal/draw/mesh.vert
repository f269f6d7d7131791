// Surfaces, once or many times.
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 color;
layout(location = 2) in vec3 normal;
layout(location = 3) in vec2 uv;
uniform mat4 clipFromShape;
uniform mat4 eyeFromShape;
uniform vec4 tint;
out vec4 own;
out vec3 eyePlace;
out vec3 eyeNormal;
out vec2 picturePlace;
#ifdef INSTANCED
layout(location = 4) in vec3 at;
layout(location = 5) in vec4 turn;
layout(location = 6) in vec3 scale;
layout(location = 7) in vec4 ownColor;

vec3 turned(vec3 v) {
  return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v);
}
#endif
#ifdef PICK
flat out uint element;
#endif

void main() {
#ifdef INSTANCED
  vec3 here = turned(place * scale) + at;
  // A scale of 0 makes a thing flat; its normals stay numbers.
  vec3 up = turned(normal / mix(scale, vec3(1e-6), equal(scale, vec3(0.0))));
  own = color * ownColor * tint;
#else
  vec3 here = place;
  vec3 up = normal;
  own = color * tint;
#endif
  gl_Position = abs(here.x + here.y + here.z) < 1e30 ? clipFromShape * vec4(here, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
  eyePlace = (eyeFromShape * vec4(here, 1.0)).xyz;
  eyeNormal = mat3(eyeFromShape) * up;
  picturePlace = uv;
#if defined(PICK) && defined(INSTANCED)
  element = uint(gl_InstanceID);
#elif defined(PICK)
  element = 0u;
#endif
}
