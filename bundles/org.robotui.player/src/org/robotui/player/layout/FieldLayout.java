package org.robotui.player.layout;

import java.util.Locale;
import java.util.Optional;

/** One field of a structure. */
public final class FieldLayout {

  /** How many values a field holds, and where their number stands. */
  enum Arity {
    /** One value. */
    ONE,
    /** So many as the layout says. */
    FIXED,
    /** As many as the message says, twice, just before them. */
    COUNTED,
    /** As many as the message says, once in an earlier place and once just before them. */
    COUNTED_EARLIER,
    /** No value: the earlier place for the number of elements of a later field. */
    COUNT
  }

  private final String name;
  private final Optional<Primitive> primitive;
  private final Optional<StructLayout> struct;
  private final Arity arity;
  private final int length;
  private final String unit;
  private final String comment;

  FieldLayout(String name, Primitive primitive, Arity arity, int length, String unit, String comment) {
    this(name, Optional.of(primitive), Optional.empty(), arity, length, unit, comment);
  }

  FieldLayout(String name, StructLayout struct, Arity arity, int length, String unit, String comment) {
    this(name, Optional.empty(), Optional.of(struct), arity, length, unit, comment);
  }

  private FieldLayout(String name, Optional<Primitive> primitive, Optional<StructLayout> struct, Arity arity,
      int length, String unit,
      String comment) {
    this.name = name;
    this.primitive = primitive;
    this.struct = struct;
    this.arity = arity;
    this.length = length;
    this.unit = unit;
    this.comment = comment;
  }

  /**
   * The field's name.
   *
   * @return words with underscores
   */
  public String name() {
    return name;
  }

  /**
   * The unit of its values.
   *
   * @return such as {@code m} or {@code rad}; empty for none
   */
  public String unit() {
    return unit;
  }

  /**
   * What it means.
   *
   * @return a few words; empty if the layout says none
   */
  public String comment() {
    return comment;
  }

  /**
   * The type of its values, of one element for an array.
   *
   * @return such as {@code f64} or the name of a structure
   */
  public String type() {
    return primitive.map(each -> each.name().toLowerCase(Locale.ROOT)).or(() -> struct.map(StructLayout::name))
        .orElseThrow();
  }

  /**
   * Whether it holds many values.
   *
   * @return false for a single one
   */
  public boolean isArray() {
    return arity != Arity.ONE;
  }

  /**
   * How many values an array always has.
   *
   * @return 0 where the message says how many, and for a single value
   */
  public int size() {
    return arity == Arity.FIXED ? length : 0;
  }

  /**
   * The structure of its values.
   *
   * @return empty if the values are numbers or text
   */
  public Optional<StructLayout> struct() {
    return struct;
  }

  Optional<Primitive> primitive() {
    return primitive;
  }

  Arity arity() {
    return arity;
  }

  int length() {
    return length;
  }

  @Override
  public String toString() {
    return type() + (isArray() ? "[]" : "") + " " + name;
  }
}
