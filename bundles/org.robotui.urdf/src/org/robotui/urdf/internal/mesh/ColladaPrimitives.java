package org.robotui.urdf.internal.mesh;

import java.util.Map;
import java.util.Optional;
import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.internal.XmlNode;

/** Triangles, lists of polygons, fans and strips. */
final class ColladaPrimitives {
  private static final FloatList NONE = new FloatList();

  private final MeshBuilder builder;
  private final Map<String, XmlNode> byId;
  private final Matrix at;
  private final CornerIndex corners = new CornerIndex();
  private Source positions = Source.NONE;
  private Source normals = Source.NONE;
  private Source places = Source.NONE;
  private int stride = 1;
  private final IntList indices = new IntList();

  ColladaPrimitives(MeshBuilder builder, Map<String, XmlNode> byId, Matrix at) {
    this.builder = builder;
    this.byId = byId;
    this.at = at;
  }

  /** Numbers, how many make one, and where their index stands. */
  private record Source(FloatList numbers, int each, int offset) {
    static final Source NONE = new Source(ColladaPrimitives.NONE, 0, 0);

    boolean there() {
      return each > 0;
    }
  }

  void read(XmlNode primitive) throws Refusal {
    for (XmlNode input : primitive.children("input")) {
      input(input, offset(input));
    }
    if (!positions.there()) {
      throw primitive.refusal("<" + primitive.name() + "> has no <input semantic=\"VERTEX\">");
    }
    switch (primitive.name()) {
      case "triangles" -> {
        for (XmlNode p : primitive.children("p")) {
          load(p);
          lists(3);
        }
      }
      case "polylist" -> polylist(primitive);
      case "polygons" -> polygons(primitive);
      default -> {
        for (XmlNode p : primitive.children("p")) {
          load(p);
          fan(0, indices.size() / stride, primitive.name().equals("tristrips"));
        }
      }
    }
  }

  private void input(XmlNode input, int offset) throws Refusal {
    stride = Math.max(stride, offset + 1);
    XmlNode source = reference(input);
    switch (input.required("semantic")) {
      case "VERTEX" -> {
        for (XmlNode inner : source.children("input")) {
          input(inner, offset);
        }
      }
      case "POSITION" -> positions = source(source, 3, offset);
      case "NORMAL" -> normals = source(source, 3, offset);
      case "TEXCOORD" -> places = places.there() ? places : source(source, 2, offset);
      default -> {}
    }
  }

  private XmlNode reference(XmlNode input) throws Refusal {
    String url = input.required("source");
    return Optional.ofNullable(byId.get(url.startsWith("#") ? url.substring(1) : url))
        .orElseThrow(() -> input.refusal("source=\"" + url + "\" is not in the file"));
  }

  private static int offset(XmlNode input) throws Refusal {
    String text = input.attribute("offset").orElse("0");
    if (!text.matches("\\d{1,2}")) {
      throw input.refusal("offset=\"" + text + "\", must be 0 to 99");
    }
    return Integer.parseInt(text);
  }

  private static Source source(XmlNode source, int least, int offset) throws Refusal {
    XmlNode array = source.requiredChild("float_array");
    String each = source.at("technique_common", "accessor").flatMap(a -> a.attribute("stride")).orElse("" + least);
    if (!each.matches("[1-9]\\d?") || Integer.parseInt(each) < least) {
      throw source.refusal("stride=\"" + each + "\", must be " + least + " to 99");
    }
    FloatList numbers = ColladaNumbers.floats(array);
    String declared = array.attribute("count").orElse("" + numbers.size());
    if (!declared.equals("" + numbers.size())) {
      throw array.refusal("<float_array> declares count=\"" + declared + "\" but holds " + numbers.size()
          + " numbers; the file is cut off or broken");
    }
    return new Source(numbers, Integer.parseInt(each), offset);
  }

  private void load(XmlNode p) throws Refusal {
    indices.clear();
    ColladaNumbers.indices(p, indices);
    if (indices.size() % stride != 0) {
      throw p.refusal("<p> has " + indices.size() + " indices, must be " + stride + " a corner");
    }
  }

  private void lists(int each) throws Refusal {
    int count = indices.size() / stride;
    for (int first = 0; first + each <= count; first += each) {
      fan(first, each, false);
    }
  }

  private void polylist(XmlNode primitive) throws Refusal {
    IntList counts = new IntList();
    ColladaNumbers.indices(primitive.requiredChild("vcount"), counts);
    load(primitive.requiredChild("p"));
    int first = 0;
    int all = indices.size() / stride;
    for (int i = 0; i < counts.size(); i++) {
      int count = counts.get(i);
      if (count < 0 || count > all - first) {
        throw primitive.refusal("<vcount> asks for more corners than the " + all + " of <p>");
      }
      fan(first, count, false);
      first += count;
    }
  }

  private void polygons(XmlNode primitive) throws Refusal {
    for (XmlNode p : primitive.children("p")) {
      load(p);
      fan(0, indices.size() / stride, false);
    }
    for (XmlNode ph : primitive.children("ph")) {
      // the holes of a polygon are filled
      load(ph.requiredChild("p"));
      fan(0, indices.size() / stride, false);
    }
  }

  /** Triangles around the first corner, or along a strip. */
  private void fan(int first, int count, boolean strip) throws Refusal {
    for (int i = 2; i < count; i++) {
      int a = strip ? first + i - 2 : first;
      triangle(corner(a), corner(first + i - 1), corner(first + i));
    }
  }

  private void triangle(int a, int b, int c) throws Refusal {
    if (!normals.there()) {
      builder.flat(a, b, c);
    }
    builder.triangle(a, b, c);
  }

  private int corner(int i) throws Refusal {
    int position = index(i, positions);
    int normal = normals.there() ? index(i, normals) : -1;
    int place = places.there() ? index(i, places) : -1;
    int known = normal < 0 ? -1 : corners.get(position, normal, place);
    if (known >= 0) {
      return known;
    }
    float x = positions.numbers.get(position);
    float y = positions.numbers.get(position + 1);
    float z = positions.numbers.get(position + 2);
    int corner = builder.corner(at.place(0, x, y, z), at.place(1, x, y, z), at.place(2, x, y, z));
    if (place >= 0) {
      builder.place(corner, places.numbers.get(place), places.numbers.get(place + 1));
    }
    if (normal >= 0) {
      normal(corner, normals.numbers.get(normal), normals.numbers.get(normal + 1), normals.numbers.get(normal + 2));
      corners.put(position, normal, place, corner);
    }
    return corner;
  }

  private void normal(int corner, float x, float y, float z) {
    builder.normal(corner, at.normal(0, x, y, z), at.normal(1, x, y, z), at.normal(2, x, y, z));
  }

  /** Where the numbers of a corner begin. */
  private int index(int corner, Source source) throws Refusal {
    long index = indices.get(corner * stride + source.offset) & 0xffff_ffffL;
    long from = index * source.each;
    if (from + source.each > source.numbers.size()) {
      throw new Refusal(0,
          "corner " + corner + " has the index " + index + ", but there are " + source.numbers.size() / source.each);
    }
    return (int) from;
  }
}
