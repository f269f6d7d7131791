package org.robotui.xbot.internal;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Where in shared memory what lies, as {@code layout.txt} says: a copy of the one that the native side is checked
 * against, so that no offset stands in Java code.
 */
public final class Layout {
  private static final String RESOURCE = "layout.txt";

  /**
   * A field of a struct.
   *
   * @param type a number's type, or the name of a struct
   * @param offset bytes from the beginning of the struct
   * @param count how many follow each other
   * @param size bytes of one
   */
  record Field(String type, int offset, int count, int size) {}

  /**
   * A struct.
   *
   * @param size bytes
   * @param fields by name
   */
  record Struct(int size, Map<String, Field> fields) {}

  private final Map<String, Integer> numbers = new HashMap<>();
  private final Map<String, Struct> structs = new LinkedHashMap<>();

  private Layout() {}

  /** Reads the layout that this bundle was made for. */
  public static Layout shipped() {
    try (InputStream stream = Optional.ofNullable(Layout.class.getResourceAsStream(RESOURCE))
        .orElseThrow(() -> new IOException(RESOURCE + " is not in the bundle"))) {
      return parse(new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Layout parse(BufferedReader lines) throws IOException {
    Layout layout = new Layout();
    Map<String, Field> fields = new HashMap<>();
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      String[] words = line.strip().split("\\s+");
      if (line.startsWith("#")) {
        continue;
      }
      if (line.startsWith("struct ")) {
        fields = new LinkedHashMap<>();
        layout.structs.put(words[1], new Struct(Integer.parseInt(words[2]), fields));
      } else if (line.startsWith(" ")) {
        fields.put(words[0],
            new Field(words[1], Integer.parseInt(words[2]), Integer.parseInt(words[3]), Integer.parseInt(words[4])));
      } else {
        layout.numbers.put(words[words.length - 2], Integer.parseInt(words[words.length - 1]));
      }
    }
    return layout;
  }

  /** A constant, such as {@code joints}. */
  int number(String name) {
    return Optional.ofNullable(numbers.get(name))
        .orElseThrow(() -> new IllegalArgumentException("no constant " + name));
  }

  /** The bytes of a struct. */
  int size(String struct) {
    return struct(struct).size();
  }

  Struct struct(String name) {
    return Optional.ofNullable(structs.get(name)).orElseThrow(() -> new IllegalArgumentException("no struct " + name));
  }

  /** Where a field of a struct begins, over structs within: {@code loop.wake_up}. */
  int offset(String struct, String path) {
    int dot = path.indexOf('.');
    String name = dot < 0 ? path : path.substring(0, dot);
    Field field = Optional.ofNullable(struct(struct).fields().get(name))
        .orElseThrow(() -> new IllegalArgumentException("no field " + name + " in " + struct));
    return field.offset() + (dot < 0 ? 0 : offset(field.type(), path.substring(dot + 1)));
  }
}
