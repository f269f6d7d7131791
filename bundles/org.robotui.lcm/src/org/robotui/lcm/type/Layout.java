package org.robotui.lcm.type;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * How the bytes of one struct follow each other. Types may hold themselves, so layouts are linked first and measured
 * then.
 */
final class Layout {

  private final TypeDefinition.Struct definition;
  private final List<Slot> slots = new ArrayList<>();
  private final Map<String, Integer> indices = new HashMap<>();
  private long minSize;
  private boolean fixed;

  Layout(TypeDefinition.Struct definition) {
    this.definition = definition;
  }

  void add(Slot slot) {
    indices.put(slot.name(), slots.size());
    slots.add(slot);
  }

  /** Says what the compiler found. */
  void measured(long least, boolean always) {
    minSize = least;
    fixed = always;
  }

  TypeDefinition.Struct definition() {
    return definition;
  }

  String type() {
    return definition.name();
  }

  List<Slot> slots() {
    return slots;
  }

  /** The index of a member, or -1. */
  int indexOf(String name) {
    return indices.getOrDefault(name, -1);
  }

  /** The fewest bytes of such a struct. */
  long minSize() {
    return minSize;
  }

  /** Whether all such structs have just {@link #minSize} bytes. */
  boolean isFixed() {
    return fixed;
  }
}
