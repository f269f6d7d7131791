package org.robotui.rfic.lcm.internal.language;

import java.util.List;
import java.util.Optional;
import org.robotui.api.input.Numerals;

/** Where the value of a field comes from. */
public sealed interface Source {
  /**
   * A number that is always the same.
   *
   * @param value in SI units
   */
  record Constant(double value) implements Source {}

  /**
   * Texts that are always the same.
   *
   * @param texts one for a single text
   */
  record Words(List<String> texts) implements Source {}

  /**
   * A member of the message.
   *
   * @param path where
   * @param factor what turns its number into SI units
   * @param unit as written, empty where none is
   */
  record Member(MemberPath path, double factor, String unit) implements Source {
    @Override
    public String toString() {
      return path + (unit.isEmpty() ? "" : " " + unit);
    }
  }

  /**
   * The sum of several, as times that are sent in two numbers.
   *
   * @param parts the members
   */
  record Sum(List<Member> parts) implements Source {}

  /**
   * Reads a source as it is written.
   *
   * @param written a text, or a list of texts
   * @param field what it is for
   * @return where the value comes from
   * @throws IllegalArgumentException where it is none; the message says what to write
   */
  static Source parse(Object written, Field field) {
    return switch (field.kind()) {
      case TEXT -> text(single(written, field));
      case TEXTS -> written instanceof List<?> l ? new Words(l.stream().map(Object::toString).toList())
          : texts(written.toString());
      case TIME -> new Sum(written instanceof List<?> l
          ? l.stream().map(part -> time(part.toString(), field)).toList()
          : List.of(time(written.toString(), field)));
      case FLAG -> flag(single(written, field), field.quantity());
      default -> number(single(written, field), field.quantity());
    };
  }

  private static String single(Object written, Field field) {
    if (written instanceof String text) {
      return text.strip();
    }
    throw new IllegalArgumentException("'" + field.name() + "' takes one value, not a list");
  }

  private static Source flag(String text, Quantity quantity) {
    return switch (text) {
      case "true", "yes", "on" -> new Constant(1);
      case "false", "no", "off" -> new Constant(0);
      default -> number(text, quantity);
    };
  }

  private static Source text(String text) {
    return text.startsWith("$") ? new Member(MemberPath.parse(text.substring(1)), 1, "") : new Words(List.of(text));
  }

  private static Source texts(String text) {
    return new Member(MemberPath.parse(text.startsWith("$") ? text.substring(1) : text), 1, "");
  }

  private static Member time(String text, Field field) {
    if (number(text, field.quantity()) instanceof Member member) {
      return member;
    }
    throw new IllegalArgumentException("'" + text + "' is no member of the message; write for example utime us");
  }

  private static Source number(String text, Quantity quantity) {
    String[] words = text.strip().split("\\s+");
    if (words[0].isEmpty()) {
      throw new IllegalArgumentException("nothing is written here; write for example pos[0] mm");
    }
    if (words.length > 2) {
      throw new IllegalArgumentException(
          "'" + text + "' is more than a member and its unit; write for example pos[0] mm");
    }
    String unit = words.length == 2 ? words[1] : "";
    double factor = unit.isEmpty() ? 1
        : quantity.factor(unit).orElseThrow(() -> new IllegalArgumentException("'" + unit + "' is no unit here"
            + (quantity.units().isEmpty() ? "; this number has none" : "; write one of " + quantity.units())));
    Optional<Double> constant = constant(words[0]);
    boolean negative = constant.isEmpty() && words[0].startsWith("-");
    return constant.<Source>map(value -> new Constant(value * factor))
        .orElseGet(() -> new Member(MemberPath.parse(negative ? words[0].substring(1) : words[0]),
            negative ? -factor : factor, unit));
  }

  private static Optional<Double> constant(String word) {
    if (word.isEmpty() || !"+-.0123456789".contains(word.substring(0, 1)) || word.matches("[+-]?[A-Za-z_].*")) {
      return Optional.empty();
    }
    return Optional.of(Numerals.decimal(word).orElseThrow(() -> new IllegalArgumentException(
        "'" + word + "' is neither a number nor a member; write for example 0.5 or pos[0]")));
  }
}
