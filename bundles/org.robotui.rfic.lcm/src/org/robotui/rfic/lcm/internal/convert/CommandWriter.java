package org.robotui.rfic.lcm.internal.convert;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.robotui.data.Data;
import org.robotui.lcm.type.Dimension;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.language.Source;
import org.robotui.rfic.lcm.internal.language.Target;

/**
 * Writes commands of one kind as messages of one type.
 *
 * @param <D> the kind
 */
public final class CommandWriter<D extends Data> {
  private static final double NANOS = 1e9;

  private final CommandForm<D> form;
  private final Map<String, Source> targets;
  private final Map<?, ?> fixed;
  private final LcmType type;
  private final TypeLibrary types;
  private final RecordFiller filler;

  /**
   * A writer. Tries it with a command that moves nothing.
   *
   * @param form the kind of commands
   * @param targets which members hold which field
   * @param fixed members that are always the same: paths with texts
   * @param type of the messages
   * @param types all types
   * @throws IllegalArgumentException where a member cannot hold what it shall; the message says why
   */
  public CommandWriter(CommandForm<D> form, Map<String, Source> targets, Map<?, ?> fixed, LcmType type,
      TypeLibrary types) {
    this.form = form;
    this.targets = Map.copyOf(targets);
    this.fixed = Map.copyOf(fixed);
    this.type = type;
    this.types = types;
    this.filler = new RecordFiller(types);
    write(form.sample(), 0);
  }

  /** The kind of commands. */
  public CommandForm<D> form() {
    return form;
  }

  /** The type of the messages. */
  public LcmType type() {
    return type;
  }

  private FieldTree tree() {
    FieldTree tree = new FieldTree();
    fixed.forEach((path, text) -> FixedMember.put(tree, path.toString(), text.toString(), type, types));
    return tree;
  }

  /**
   * Writes a command.
   *
   * @param command the command
   * @param nowNanos nanoseconds since 1970
   * @return the message
   */
  public ByteBuffer write(D command, long nowNanos) {
    FieldTree tree = tree();
    Map<String, Object> parts = form.parts().of(command);
    targets.forEach((field, source) -> {
      switch (source) {
        case Source.Member m -> tree.put(m.path(), part(parts.get(field), m));
        case Source.Sum s -> stamp(tree, s, nowNanos);
        case Source.Constant c -> {}
        case Source.Words w -> {}
      }
    });
    return type.encode(filler.fill(type, tree.fields()));
  }

  private Object part(Object part, Source.Member target) {
    return switch (part) {
      case Double d -> rounded(d / target.factor(), target);
      case double[] numbers -> list(ordered(numbers, target), target);
      default -> part;
    };
  }

  /** Whole numbers are what some robots take, in small units. */
  private Object rounded(double value, Source.Member target) {
    boolean whole = Target.of(target.path(), type, types).primitive().filter(p -> p.isInteger()).isPresent();
    return whole ? Object.class.cast(Math.round(value)) : Object.class.cast(value);
  }

  private static double[] ordered(double[] numbers, Source.Member target) {
    return target.unit().equals("xyzw") ? new double[]{numbers[1], numbers[2], numbers[3], numbers[0]} : numbers;
  }

  /** As many as the array has, where its size is fixed: a place in a plane has two. */
  private List<Object> list(double[] numbers, Source.Member target) {
    Target to = Target.of(target.path(), type, types);
    if (!to.many() || to.member().dimensions().size() != 1) {
      throw new IllegalArgumentException(target.path() + " is declared as '" + to.member()
          + "' and takes one number; write which axis it is, as x or wz");
    }
    int size = to.member().dimensions().getFirst() instanceof Dimension.Fixed fixed ? fixed.size() : numbers.length;
    List<Object> list = new ArrayList<>(size);
    for (int i = 0; i < size; i++) {
      list.add(rounded(i < numbers.length ? numbers[i] / target.factor() : 0, target));
    }
    return list;
  }

  /** Into several numbers: each takes what those before it left. */
  private void stamp(FieldTree tree, Source.Sum sum, long nowNanos) {
    long left = nowNanos;
    for (int i = 0; i < sum.parts().size(); i++) {
      Source.Member part = sum.parts().get(i);
      long unit = Math.round(part.factor() * NANOS);
      boolean floating = Target.of(part.path(), type, types).primitive().filter(p -> p.isFloating()).isPresent();
      tree.put(part.path(), floating ? Object.class.cast(left / (double) unit) : Object.class.cast(left / unit));
      left = floating ? 0 : left % unit;
    }
  }
}
