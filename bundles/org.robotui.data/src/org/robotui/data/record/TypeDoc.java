package org.robotui.data.record;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What users may want to know of a data type: what it means, its fields, and their units. It says what the source code
 * of the type says.
 *
 * @param name the name of the type, for example {@code LaserScan}, or {@code JointState.Joint} for one within another
 * @param text what it stands for; paragraphs are separated by line breaks
 * @param fields in their order; none where values have no fixed fields
 */
public record TypeDoc(String name, String text, List<Field> fields) {
  private static final String FILE = "types.txt";
  private static final String TYPE = "= ";
  private static final String FIELD = "- ";

  /**
   * One field.
   *
   * @param name as in paths
   * @param type what it holds
   * @param text what it means, with its unit
   */
  public record Field(String name, String type, String text) {}

  /**
   * Copies the list.
   *
   * @param name the name of the type
   * @param text what it stands for
   * @param fields in their order
   */
  public TypeDoc {
    fields = List.copyOf(fields);
  }

  /**
   * The description of a type, and of those that it is made of.
   *
   * @param type name of a data type
   * @return the type itself first; nothing for a name that is none of a data type
   */
  public static List<TypeDoc> find(String type) {
    List<TypeDoc> all = all();
    List<TypeDoc> found = new ArrayList<>();
    all.stream().filter(doc -> doc.name().equals(type)).findFirst().ifPresent(found::add);
    for (int i = 0; i < found.size(); i++) {
      for (Field field : found.get(i).fields()) {
        part(all, found.get(i).name(), field.type()).filter(doc -> !found.contains(doc)).ifPresent(found::add);
      }
    }
    return List.copyOf(found);
  }

  /** The record that a field holds, or a list of it. */
  private static Optional<TypeDoc> part(List<TypeDoc> all, String within, String type) {
    String bare = type.replaceAll("^[A-Za-z]+<(.*)>$", "$1");
    String outer = within.replaceAll("\\..*", "");
    return all.stream().filter(doc -> doc.name().equals(outer + "." + bare)).findFirst()
        .or(() -> all.stream().filter(doc -> doc.name().equals(bare)).findFirst());
  }

  private static List<TypeDoc> all() {
    try (InputStream in = TypeDoc.class.getResourceAsStream(FILE)) {
      return read(new String(in.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException("the descriptions of data types cannot be read from their bundle", e);
    }
  }

  private static List<TypeDoc> read(String text) {
    List<TypeDoc> all = new ArrayList<>();
    for (String part : text.split("(?m)^" + TYPE)) {
      if (!part.isBlank()) {
        all.add(one(part.lines().toList()));
      }
    }
    return all;
  }

  private static TypeDoc one(List<String> lines) {
    List<Field> fields = lines.stream().filter(line -> line.startsWith(FIELD))
        .map(line -> line.substring(FIELD.length()).split("\t", -1))
        .map(words -> new Field(words[0], words[1], words[2])).toList();
    String text = String.join("\n", lines.stream().skip(1).filter(line -> !line.startsWith(FIELD)).toList());
    return new TypeDoc(lines.getFirst(), text, fields);
  }
}
