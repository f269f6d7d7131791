#ifdef PICK
uniform uint part;
out uvec2 found;
#else
out vec4 pixel;
#endif
in vec4 shade;

void main() {
#ifdef PICK
  found = uvec2(part, uint(gl_PrimitiveID));
#else
  pixel = shade;
#endif
}
