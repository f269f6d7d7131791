package org.robotui.urdf.internal.mesh;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.urdf.internal.Refusal;

/** Reads OBJ, with the colours of its MTL. */
public final class ObjReader {
  private final MeshBuilder builder;
  private final List<String> warnings;
  private final Function<String, Optional<byte[]>> beside;
  private final FloatList positions = new FloatList();
  private final FloatList normals = new FloatList();
  private final FloatList places = new FloatList();
  private final IntList face = new IntList();
  private final Map<String, MtlReader.Look> looks = new HashMap<>();
  private CornerIndex corners = new CornerIndex();
  private MtlReader.Look look = MtlReader.Look.NONE;

  /** Takes where triangles and warnings go, and what gives files beside it. */
  public ObjReader(MeshBuilder builder, List<String> warnings, Function<String, Optional<byte[]>> beside) {
    this.builder = builder;
    this.warnings = warnings;
    this.beside = beside;
  }

  /** Adds all faces, cut into triangles. */
  public void read(byte[] bytes) throws Refusal {
    WordReader words = new WordReader(bytes);
    for (Optional<String> word = words.next(); word.isPresent(); word = words.next()) {
      switch (word.get()) {
        case "v" -> numbers(words, positions, 3);
        case "vn" -> numbers(words, normals, 3);
        case "vt" -> numbers(words, places, 2);
        case "f" -> face(words);
        case "usemtl" -> use(words.rest());
        case "mtllib" -> library(words.rest());
        default -> {}
      }
      words.skipLine();
    }
    endPart();
  }

  private static void numbers(WordReader words, FloatList into, int count) throws Refusal {
    for (int i = 0; i < count; i++) {
      Optional<String> word = words.nextInLine();
      if (word.isEmpty() && i == 0) {
        throw new Refusal(words.line(), "coordinates without a number");
      }
      into.add(word.isPresent() ? words.number(word.get()) : 0);
    }
  }

  private void face(WordReader words) throws Refusal {
    face.clear();
    for (Optional<String> word = words.nextInLine(); word.isPresent(); word = words.nextInLine()) {
      String[] parts = word.get().split("/", -1);
      face.add(index(parts, 0, positions.size() / 3, words.line()));
      face.add(index(parts, 1, places.size() / 2, words.line()));
      face.add(index(parts, 2, normals.size() / 3, words.line()));
    }
    int count = face.size() / 3;
    if (count > 0 && face.get(0) < 0) {
      throw new Refusal(words.line(), "a face without a vertex");
    }
    for (int i = 2; i < count; i++) {
      triangle(0, i - 1, i);
    }
  }

  private void triangle(int... of) throws Refusal {
    boolean flat = face.get(3 * of[0] + 2) < 0 || face.get(3 * of[1] + 2) < 0 || face.get(3 * of[2] + 2) < 0;
    int a = corner(of[0], flat);
    int b = corner(of[1], flat);
    int c = corner(of[2], flat);
    builder.flat(a, b, c);
    builder.triangle(a, b, c);
  }

  private int corner(int i, boolean flat) throws Refusal {
    int position = face.get(3 * i);
    int place = face.get(3 * i + 1);
    int normal = face.get(3 * i + 2);
    int known = flat ? -1 : corners.get(position, normal, place);
    if (known >= 0) {
      return known;
    }
    int corner =
        builder.corner(positions.get(3 * position), positions.get(3 * position + 1), positions.get(3 * position + 2));
    if (normal >= 0 && !flat) {
      builder.normal(corner, normals.get(3 * normal), normals.get(3 * normal + 1), normals.get(3 * normal + 2));
    }
    if (place >= 0) {
      builder.place(corner, places.get(2 * place), places.get(2 * place + 1));
    }
    if (!flat) {
      corners.put(position, normal, place, corner);
    }
    return corner;
  }

  /** From 0, also where it is written backwards from the end; -1 where there is none. */
  private static int index(String[] parts, int part, int count, int line) throws Refusal {
    if (part >= parts.length || parts[part].isEmpty()) {
      if (part == 0) {
        throw new Refusal(line, "a face without a vertex");
      }
      return -1;
    }
    try {
      int written = Integer.parseInt(parts[part]);
      int index = written < 0 ? count + written : written - 1;
      if (index >= 0 && index < count) {
        return index;
      }
    } catch (NumberFormatException e) {
      // the message below says it with its line
    }
    throw new Refusal(line, "a face names '" + parts[part] + "', but there are " + count + " so far");
  }

  private void use(String name) {
    endPart();
    look = looks.getOrDefault(name, MtlReader.Look.NONE);
  }

  private void library(String name) throws Refusal {
    Optional<byte[]> bytes = beside.apply(name);
    if (bytes.isPresent()) {
      looks.putAll(MtlReader.read(bytes.get()));
    } else {
      warnings.add("the file of materials '" + name + "' cannot be read beside it");
    }
  }

  private void endPart() {
    builder.part(look.color(), look.texture());
    corners = new CornerIndex();
  }
}
