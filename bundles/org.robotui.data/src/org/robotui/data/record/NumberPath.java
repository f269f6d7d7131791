package org.robotui.data.record;

import java.lang.ref.WeakReference;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;

/**
 * A path by which the same number is read out of many values. What leads there in Java records is looked up once, and
 * again where a value is of another type. For one thread.
 */
public final class NumberPath {
  private final FieldPath path;
  private final Hop[] hops;

  /**
   * Has looked up nothing yet.
   *
   * @param path for example {@code pose.position.x} or {@code ranges[3]}
   */
  public NumberPath(FieldPath path) {
    this.path = path;
    this.hops = path.steps().stream().map(NumberPath::hop).toArray(Hop[]::new);
  }

  /**
   * Reads the number out of one value.
   *
   * @param record where the path begins
   * @return the number, or none where there is something else or nothing
   */
  public OptionalDouble in(DynamicRecord record) {
    if (!(record instanceof DataRecord data)) {
      return record.number(path);
    }
    OptionalDouble number = follow(data.value());
    return number.isPresent() ? number : data.numberOfFields(path);
  }

  /** None where the way by the fields of records has to tell what is there. */
  private OptionalDouble follow(Object value) {
    Object at = value;
    int last = hops.length - 1;
    for (int i = 0; i < last && at != null; i++) {
      at = hops[i].follow(at);
    }
    return at == null || last < 0 ? OptionalDouble.empty() : hops[last].number(at);
  }

  private static Hop hop(FieldPath.Step step) {
    return switch (step) {
      case FieldPath.Step.Field field -> new FieldHop(field.name());
      case FieldPath.Step.Element element -> new ElementHop(element.index());
    };
  }

  private static OptionalDouble number(Object value) {
    return value instanceof Number number ? OptionalDouble.of(number.doubleValue()) : OptionalDouble.empty();
  }

  /** One step. */
  private sealed interface Hop {
    /** Null where there is nothing: an optional for each step to millions of values takes its time. */
    Object follow(Object at);

    OptionalDouble number(Object at);
  }

  /** Into a field of a record. */
  private static final class FieldHop implements Hop {
    private final String name;
    /** Weak, so that whoever reads does not keep the bundle of a type; the type keeps it. */
    private WeakReference<RecordField> known = new WeakReference<>(null);

    FieldHop(String name) {
      this.name = name;
    }

    @Override
    public Object follow(Object at) {
      RecordField field = field(at);
      Object value = field == null ? null : field.raw((Record) at);
      return value instanceof Optional<?> optional ? optional.orElse(null) : value;
    }

    @Override
    public OptionalDouble number(Object at) {
      RecordField field = field(at);
      if (field == null) {
        return OptionalDouble.empty();
      }
      return field.isNumber() ? field.number((Record) at) : NumberPath.number(follow(at));
    }

    private RecordField field(Object at) {
      RecordField field = known.get();
      return field != null && field.type() == at.getClass() ? field : lookUp(at);
    }

    private RecordField lookUp(Object at) {
      boolean other = !(at instanceof Record) || at instanceof DynamicRecord || at instanceof Stamp
          || at instanceof FrameId;
      RecordField field = other ? null : RecordFields.of(at.getClass()).find(name).orElse(null);
      known = new WeakReference<>(field);
      return field;
    }
  }

  /** Into an element of what is many. */
  private record ElementHop(int index) implements Hop {
    @Override
    public Object follow(Object at) {
      return at instanceof List<?> list && index < list.size() ? list.get(index) : null;
    }

    @Override
    public OptionalDouble number(Object at) {
      return switch (at) {
        case Doubles numbers when index < numbers.size() -> OptionalDouble.of(numbers.get(index));
        case Floats numbers when index < numbers.size() -> OptionalDouble.of(numbers.get(index));
        default -> NumberPath.number(follow(at));
      };
    }
  }
}
