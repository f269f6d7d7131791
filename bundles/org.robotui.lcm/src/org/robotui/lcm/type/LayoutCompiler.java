package org.robotui.lcm.type;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedSet;

/** Makes the layout of one struct and of those it holds, and finds those that cannot be sent. */
final class LayoutCompiler {

  private static final int MOST_NESTED = 200;

  private final Map<String, TypeDefinition> types;
  private final Map<String, Layout> linked = new HashMap<>();
  private final SequencedSet<Layout> measuring = new LinkedHashSet<>();
  private final SequencedSet<Layout> measured = new LinkedHashSet<>();

  private LayoutCompiler(Map<String, TypeDefinition> types) {
    this.types = types;
  }

  /** The layout, linked with all it refers to. Nothing of it is shared: what one type lacks, others need not. */
  static Layout compile(TypeDefinition.Struct struct, Map<String, TypeDefinition> types) throws TypeException {
    LayoutCompiler compiler = new LayoutCompiler(types);
    Layout root = compiler.link(struct, 0);
    for (Layout each : compiler.linked.values()) {
      compiler.measure(each);
    }
    return root;
  }

  private Layout link(TypeDefinition.Struct struct, int depth) throws TypeException {
    Layout known = linked.get(struct.name());
    if (known != null) {
      return known;
    }
    if (depth > MOST_NESTED) {
      throw new TypeException(struct.place(), "types are nested deeper than " + MOST_NESTED, "nest fewer");
    }
    Layout layout = new Layout(struct);
    linked.put(struct.name(), layout);
    for (MemberDefinition member : struct.members()) {
      List<Slot.Extent> extents = member.dimensions().stream().map(dimension -> extent(layout, dimension)).toList();
      layout.add(new Slot(member, element(member, depth), extents));
    }
    return layout;
  }

  private static Slot.Extent extent(Layout layout, Dimension dimension) {
    return switch (dimension) {
      case Dimension.Fixed(int size, String text) -> new Slot.Extent(size, -1);
      case Dimension.Variable(String name) -> new Slot.Extent(0, layout.indexOf(name));
    };
  }

  private Slot.Element element(MemberDefinition member, int depth) throws TypeException {
    Optional<Primitive> primitive = Primitive.of(member.type());
    if (primitive.isPresent()) {
      return new Slot.Builtin(primitive.get());
    }
    return switch (types.get(member.type())) {
      case null -> throw new TypeException(member.place(), "the type '" + member.type() + "' is not known",
          "add the .lcm file that declares it, or correct its name");
      case TypeDefinition.Enumeration enumeration -> new Slot.Builtin(Primitive.INT32);
      case TypeDefinition.Struct struct -> new Slot.Struct(link(struct, depth + 1));
    };
  }

  private void measure(Layout layout) throws TypeException {
    if (measured.contains(layout)) {
      return;
    }
    measuring.add(layout);
    long least = 0;
    boolean fixed = true;
    for (Slot slot : layout.slots()) {
      if (slot.isVariable()) {
        fixed = false;
      } else {
        fixed &= measureElement(slot);
        long count = slot.extents().stream().mapToLong(Slot.Extent::size).reduce(1, Slot::product);
        least = Slot.sum(least, Slot.product(count, slot.elementSize()));
      }
    }
    measuring.remove(layout);
    measured.add(layout);
    layout.measured(least, fixed);
  }

  /** Answers whether all such elements are of one size. A struct that always holds itself would never end. */
  private boolean measureElement(Slot slot) throws TypeException {
    if (!(slot.element() instanceof Slot.Struct(Layout nested))) {
      return slot.primitive().orElseThrow() != Primitive.STRING;
    }
    if (measuring.contains(nested)) {
      throw new TypeException(slot.member().place(),
          "'" + slot.member() + "' holds itself, so that no message would end",
          "make it an array of variable size, which may be empty");
    }
    measure(nested);
    return nested.isFixed();
  }
}
