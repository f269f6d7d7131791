// Surfaces in the light of a lamp beside the eye, under a bright sky and over a dark ground; seen from both sides.
in vec4 own;
in vec3 eyePlace;
in vec3 eyeNormal;
in vec2 picturePlace;
uniform float perspective;
uniform vec3 up;
uniform vec4 glow;
#ifdef TEXTURED
uniform sampler2D picture;
#endif
#ifdef PICK
uniform uint part;
flat in uint element;
out uvec2 found;
#else
out vec4 pixel;
#endif

const vec3 LAMP = normalize(vec3(-1.0, 0.35, 0.55));

vec3 facing() {
#ifdef FACETS
  vec3 normal = normalize(cross(dFdx(eyePlace), dFdy(eyePlace)));
#else
  vec3 normal = normalize(eyeNormal);
#endif
  vec3 toEye = mix(vec3(-1.0, 0.0, 0.0), normalize(-eyePlace), perspective);
  return dot(normal, toEye) < 0.0 ? -normal : normal;
}

void main() {
  vec4 base = own;
#ifdef TEXTURED
  base *= texture(picture, picturePlace);
#endif
  if (base.a < 0.004) discard;
#ifdef PICK
#ifdef INSTANCED
  found = uvec2(part, element);
#else
  found = uvec2(part, uint(gl_PrimitiveID));
#endif
#else
#ifdef LIT
  vec3 normal = facing();
  float sky = 0.5 + 0.5 * dot(normal, up);
  float lamp = max(dot(normal, LAMP), 0.0);
  base.rgb *= mix(0.42, 0.6, sky) + 0.45 * lamp;
#endif
  pixel = vec4(mix(base.rgb, glow.rgb, glow.a), base.a);
#endif
}
