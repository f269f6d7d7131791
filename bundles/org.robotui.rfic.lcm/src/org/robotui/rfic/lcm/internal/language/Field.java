package org.robotui.rfic.lcm.internal.language;

import java.util.List;

/**
 * A field of what a message becomes, or of a command.
 *
 * @param name as written in configurations
 * @param kind what it holds
 * @param quantity what its numbers measure
 * @param group fields of one group say the same in several ways: where one of them is written, nothing is assumed for
 * the others
 * @param assumed sources that are tried in turn where nothing of the group is written
 */
public record Field(String name, Kind kind, Quantity quantity, String group, List<String> assumed) {
  /** What a field holds. */
  public enum Kind {
    /** One number. */
    NUMBER,
    /** Numbers. */
    NUMBERS,
    /** One text: written as it is, or a member after a {@code $}. */
    TEXT,
    /** Texts. */
    TEXTS,
    /** True or false, or a number that is not 0. */
    FLAG,
    /** The bytes of an array. */
    BYTES,
    /** A time, exact to the nanosecond. */
    TIME
  }

  /** Copies the list. */
  public Field {
    assumed = List.copyOf(assumed);
  }

  /** A number. */
  public static Field number(String name, Quantity quantity, String... assumed) {
    return new Field(name, Kind.NUMBER, quantity, name, List.of(assumed));
  }

  /** Numbers. */
  public static Field numbers(String name, Quantity quantity, String... assumed) {
    return new Field(name, Kind.NUMBERS, quantity, name, List.of(assumed));
  }

  /** A text. */
  public static Field text(String name, String... assumed) {
    return new Field(name, Kind.TEXT, Quantity.PLAIN, name, List.of(assumed));
  }

  /** Texts. */
  public static Field texts(String name, String... assumed) {
    return new Field(name, Kind.TEXTS, Quantity.PLAIN, name, List.of(assumed));
  }

  /** A truth value. */
  public static Field flag(String name, String... assumed) {
    return new Field(name, Kind.FLAG, Quantity.PLAIN, name, List.of(assumed));
  }

  /** Bytes. */
  public static Field bytes(String name, String... assumed) {
    return new Field(name, Kind.BYTES, Quantity.PLAIN, name, List.of(assumed));
  }

  /** When it was measured, or sent. */
  public static Field stamp() {
    return new Field("stamp", Kind.TIME, Quantity.TIME, "stamp", List.of("utime us"));
  }

  /** The same field in a group. */
  public Field in(String newGroup) {
    return new Field(name, kind, quantity, newGroup, assumed);
  }
}
