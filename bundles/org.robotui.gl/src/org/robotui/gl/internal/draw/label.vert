// Letters, in the plane of the picture: so many pixels or metres high. Pictures stand on their heads.
layout(location = 0) in vec4 corner;
uniform mat4 clipFromShape;
uniform mat4 clipFromEye;
uniform mat4 eyeFromShape;
uniform float height;
uniform vec2 pixel;
out vec2 glyphPlace;

void main() {
#ifdef METRES
  vec4 eye = eyeFromShape * vec4(0.0, 0.0, 0.0, 1.0);
  gl_Position = clipFromEye * (eye + vec4(0.0, -corner.x * height, corner.y * height, 0.0));
#else
  gl_Position = clipFromShape * vec4(0.0, 0.0, 0.0, 1.0);
  gl_Position.xy += vec2(corner.x, -corner.y) * height * pixel * gl_Position.w;
#endif
  glyphPlace = corner.zw;
}
