// Letters from a picture of distances: 1 on the line of a letter, 0 some pixels away.
uniform sampler2D picture;
uniform vec4 tint;
uniform vec4 glow;
uniform vec3 rim;
in vec2 glyphPlace;
#ifdef PICK
uniform uint part;
out uvec2 found;
#else
out vec4 pixel;
#endif

const float STROKE = 0.74;
const float RIM = 0.42;

void main() {
  float near = texture(picture, glyphPlace).r;
  float soft = max(fwidth(near), 0.02);
  float inside = smoothstep(STROKE - soft, STROKE + soft, near);
  float around = smoothstep(RIM - soft, RIM + soft, near);
#ifdef PICK
  if (around < 0.5) discard;
  found = uvec2(part, 0u);
#else
  if (around < 0.01) discard;
  vec3 ink = mix(tint.rgb, glow.rgb, glow.a);
  pixel = vec4(mix(rim, ink, inside), tint.a * max(inside, 0.75 * around));
#endif
}
