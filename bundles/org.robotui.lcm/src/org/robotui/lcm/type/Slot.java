package org.robotui.lcm.type;

import java.util.List;
import java.util.Optional;

/**
 * One member in a layout.
 *
 * @param member its definition
 * @param element what it holds, once or several times
 * @param extents of an array, outermost first
 */
record Slot(MemberDefinition member, Element element, List<Extent> extents) {

  /** Sizes that are larger than any message are all alike. */
  static final long ENDLESS = 1L << 40;

  /** What a member holds. */
  sealed interface Element {}

  /** A built-in type. */
  record Builtin(Primitive primitive) implements Element {}

  /** Another struct. */
  record Struct(Layout layout) implements Element {}

  /** The size of one dimension: a number, or in which member of the same struct it stands. */
  record Extent(int size, int slot) {

    boolean isFixed() {
      return slot < 0;
    }
  }

  String name() {
    return member.name();
  }

  boolean isArray() {
    return !extents.isEmpty();
  }

  boolean isVariable() {
    return !extents.stream().allMatch(Extent::isFixed);
  }

  Optional<Primitive> primitive() {
    return element instanceof Builtin builtin ? Optional.of(builtin.primitive()) : Optional.empty();
  }

  /** The fewest bytes of one element. */
  long elementSize() {
    return switch (element) {
      case Builtin builtin -> builtin.primitive() == Primitive.STRING ? Integer.BYTES : builtin.primitive().size();
      case Struct struct -> struct.layout().minSize();
    };
  }

  static long sum(long one, long other) {
    return Math.min(ENDLESS, one + other);
  }

  static long product(long one, long other) {
    return one != 0 && other > ENDLESS / one ? ENDLESS : one * other;
  }
}
