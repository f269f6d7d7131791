// Points that the processor has drawn, with their depths.
uniform sampler2D colors;
uniform sampler2D depths;
out vec4 pixel;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depths, here, 0).r;
  if (depth >= 1.0) discard;
  gl_FragDepth = depth;
  pixel = texelFetch(colors, here, 0);
}
