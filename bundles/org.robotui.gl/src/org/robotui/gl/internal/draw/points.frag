#ifdef PICK
uniform uint part;
flat in uint element;
out uvec2 found;
#else
in vec4 shade;
out vec4 pixel;
#endif

void main() {
#ifdef DISC
  vec2 off = gl_PointCoord - 0.5;
  if (dot(off, off) > 0.25) discard;
#endif
#ifdef PICK
  found = uvec2(part, element);
#else
  pixel = shade;
#endif
}
