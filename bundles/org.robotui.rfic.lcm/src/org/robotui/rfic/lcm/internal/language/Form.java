package org.robotui.rfic.lcm.internal.language;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Which fields something has that a configuration maps.
 *
 * @param word its name after {@code as:}
 * @param fields its fields
 * @param needs what must be there; each one of several ways, each of these some fields
 */
public record Form(String word, List<Field> fields, List<Need> needs) {
  /**
   * Something that must be there.
   *
   * @param ways one of them is enough: all of its fields
   */
  public record Need(List<List<String>> ways) {
    /** In words. */
    @Override
    public String toString() {
      return ways.stream().map(way -> "'" + String.join("' and '", way) + "'").collect(Collectors.joining(", or "));
    }
  }

  /** Copies the lists. */
  public Form {
    fields = List.copyOf(fields);
    needs = List.copyOf(needs);
  }

  /**
   * A form.
   *
   * @param word its name
   * @param needs each as {@code position | x y}: ways with bars between, fields with blanks between
   * @param fields its fields
   * @return the form
   */
  public static Form of(String word, List<String> needs, List<Field> fields) {
    return new Form(word, fields, needs.stream().map(n -> new Need(
        Arrays.stream(n.split("\\|")).map(way -> List.of(way.strip().split(" +"))).toList())).toList());
  }

  /** Finds a field. */
  public Optional<Field> field(String name) {
    return fields.stream().filter(f -> f.name().equals(name)).findFirst();
  }

  /** All names, for messages. */
  public String names() {
    return fields.stream().map(Field::name).collect(Collectors.joining(", "));
  }
}
