package org.robotui.roblets.tree;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;

/**
 * An element of a message, with all below it.
 *
 * @param name letters, digits, {@code _ . -}; at most 64 characters
 * @param attributes by their names, in their order
 * @param text what stands between its tags, without blanks at both ends
 * @param children in their order
 */
public record BodyElement(String name, Map<String, String> attributes, String text, List<BodyElement> children) {
  private static final Pattern NAME = Pattern.compile("[A-Za-z_][A-Za-z0-9_.-]{0,63}");

  /**
   * Copies map and list.
   *
   * @param name the name
   * @param attributes the attributes
   * @param text the text
   * @param children the children
   * @throws IllegalArgumentException where a name is none
   */
  public BodyElement {
    checked(name);
    attributes.keySet().forEach(BodyElement::checked);
    attributes = Collections.unmodifiableMap(new LinkedHashMap<>(attributes));
    children = List.copyOf(children);
    text = text.strip();
  }

  /**
   * An element without anything in it.
   *
   * @param name its name
   * @return the element
   */
  public static BodyElement of(String name) {
    return new BodyElement(name, Map.of(), "", List.of());
  }

  /**
   * A name that elements and roblets may have.
   *
   * @param name to be judged
   * @return the name
   * @throws IllegalArgumentException where it is none; says what is one
   */
  public static String checked(String name) {
    if (!NAME.matcher(name).matches()) {
      String begin = name.length() > 80 ? name.substring(0, 80) + "..." : name;
      throw new IllegalArgumentException("'" + begin.replaceAll("\\p{Cntrl}", " ")
          + "' is no name: letters, digits, '_', '.' and '-', not more than 64, with a letter first");
    }
    return name;
  }

  /**
   * This element with one attribute more, or with another value of it.
   *
   * @param attribute its name
   * @param value its value; numbers are written so that they are read as the same
   * @return the element
   */
  public BodyElement with(String attribute, Object value) {
    Map<String, String> more = new LinkedHashMap<>(attributes);
    more.put(attribute, String.valueOf(value));
    return new BodyElement(name, more, text, children);
  }

  /**
   * This element with other children.
   *
   * @param all the children
   * @return the element
   */
  public BodyElement with(List<BodyElement> all) {
    return new BodyElement(name, attributes, text, all);
  }

  /**
   * The value of an attribute.
   *
   * @param attribute its name
   * @return none where there is no such attribute
   */
  public Optional<String> attribute(String attribute) {
    return Optional.ofNullable(attributes.get(attribute));
  }

  /**
   * The value of an attribute as a number.
   *
   * @param attribute its name
   * @return none where there is no such attribute or it is no number
   */
  public OptionalDouble number(String attribute) {
    String text = attributes.getOrDefault(attribute, "");
    if (text.isBlank() || text.length() > 64) {
      return OptionalDouble.empty();
    }
    try {
      return OptionalDouble.of(Double.parseDouble(text));
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }

  /**
   * A number that has to be there.
   *
   * @param attribute its name
   * @return the number
   * @throws IllegalArgumentException where it is not there or no finite number; names element and attribute
   */
  public double needed(String attribute) {
    double value = number(attribute).orElse(Double.NaN);
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(name + " has no finite number '" + attribute + "'"
          + attribute(attribute).map(t -> ", but '" + (t.length() > 40 ? t.substring(0, 40) + "..." : t) + "'")
              .orElse(""));
    }
    return value;
  }

  /**
   * The first child of a name.
   *
   * @param child its name
   * @return none where there is no such child
   */
  public Optional<BodyElement> child(String child) {
    return children.stream().filter(c -> c.name().equals(child)).findFirst();
  }
}
