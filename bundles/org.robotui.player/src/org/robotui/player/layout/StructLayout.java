package org.robotui.player.layout;

import java.util.List;
import java.util.Optional;

/** A structure: named fields in the order of the wire. */
public final class StructLayout {

  private final String name;
  private final String comment;
  private final List<FieldLayout> wire;
  private final List<FieldLayout> fields;

  StructLayout(String name, String comment, List<FieldLayout> wire) {
    this.name = name;
    this.comment = comment;
    this.wire = List.copyOf(wire);
    this.fields = this.wire.stream().filter(field -> field.arity() != FieldLayout.Arity.COUNT).toList();
  }

  /**
   * The structure's name.
   *
   * @return words with underscores
   */
  public String name() {
    return name;
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
   * The fields.
   *
   * @return in the order of the wire
   */
  public List<FieldLayout> fields() {
    return fields;
  }

  /**
   * One of the fields.
   *
   * @param wanted its name
   * @return empty if there is no such field
   */
  public Optional<FieldLayout> field(String wanted) {
    return fields.stream().filter(field -> field.name().equals(wanted)).findFirst();
  }

  /** The fields with the places of counts between them. */
  List<FieldLayout> wire() {
    return wire;
  }

  @Override
  public String toString() {
    return name + fields;
  }
}
