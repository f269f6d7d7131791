package org.robotui.roblets.tree;

import java.util.ArrayList;
import java.util.List;

/**
 * How a message is described to who does not know its type, as roblets do in their beacons.
 *
 * @param name of its element
 * @param as what it is, such as {@code gpsfix}; empty where nothing is said
 * @param fields which numbers and texts it has
 */
public record BodyForm(String name, String as, List<Field> fields) {
  private static final int MOST_FIELDS = 64;

  /**
   * An attribute of the message, or of an element in it.
   *
   * @param name of the attribute, after the elements in which it is, with {@code /} between
   * @param kind {@code number}, {@code whole}, {@code flag} or {@code text}
   * @param unit empty where there is none
   */
  public record Field(String name, String kind, String unit) {}

  /**
   * Copies the list.
   *
   * @param name of its element
   * @param as what it is
   * @param fields its fields
   * @throws IllegalArgumentException where the name is none
   */
  public BodyForm {
    BodyElement.checked(name);
    fields = List.copyOf(fields.subList(0, Math.min(MOST_FIELDS, fields.size())));
  }

  /**
   * Written into a beacon.
   *
   * @param direction {@code output} or {@code input}
   * @return the element
   */
  public BodyElement element(String direction) {
    List<BodyElement> parts = new ArrayList<>();
    fields.forEach(field -> parts.add(BodyElement.of("field").with("name", field.name()).with("kind", field.kind())
        .with("unit", field.unit())));
    return BodyElement.of(direction).with("name", name).with("as", as).with(parts);
  }

  /**
   * Read from a beacon.
   *
   * @param element as it was written
   * @return the form
   * @throws IllegalArgumentException where the name is none
   */
  public static BodyForm of(BodyElement element) {
    return new BodyForm(element.attribute("name").orElse(""), element.attribute("as").orElse(""),
        element.children().stream().filter(c -> c.name().equals("field")).map(c -> new Field(
            c.attribute("name").orElse(""), c.attribute("kind").orElse("text"), c.attribute("unit").orElse("")))
            .toList());
  }
}
