package org.robotui.bridge.internal.change;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Optional;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.record.DynamicRecord;

/**
 * Gives the frames and stamps within values their other names and times, whatever the data type: data types are records
 * of records. Records of messages are rewritten by the names that their fields have.
 *
 * @param frames what frames are called
 * @param stamps what is added to stamps
 */
public record ValueRewriting(FrameRenaming frames, StampMoving stamps) {
  private static final String DATA = "org.robotui.data";

  /** What comes of a class alone; asking it anew for each value would cost far more than the value. */
  private static final ClassValue<Form> FORMS = new ClassValue<>() {
    @Override
    protected Form computeValue(Class<?> type) {
      return Form.of(type);
    }
  };

  /** What a record consists of, and how another one is made. */
  private record Form(List<Method> parts, Constructor<?> maker) {

    static Form of(Class<?> type) {
      List<RecordComponent> components = List.of(type.getRecordComponents());
      try {
        return new Form(components.stream().map(RecordComponent::getAccessor).toList(),
            type.getDeclaredConstructor(components.stream().map(RecordComponent::getType).toArray(Class<?>[]::new)));
      } catch (NoSuchMethodException e) {
        throw new IllegalStateException("a data type is no public record: " + type.getName(), e);
      }
    }
  }

  /** Whether a message stays what it is. */
  public boolean isNone() {
    return frames.isNone() && stamps.isNone();
  }

  /** The value for the other robot. */
  public Data of(Data value, Optional<Stamp> stamp) {
    return value instanceof DynamicRecord record ? of(record, stamp) : (Data) rewritten(value);
  }

  /** The record for the other robot. */
  public DynamicRecord of(DynamicRecord record, Optional<Stamp> stamp) {
    return isNone() ? record
        : new RewrittenRecord(record, frames, stamps.shiftNanos(),
            stamps.isNone() ? Optional.empty() : stamp, Optional.empty());
  }

  private Object rewritten(Object value) {
    return switch (value) {
      case FrameId frame -> frames.of(frame);
      case Stamp stamp -> new Stamp(stamp.nanos() + stamps.shiftNanos(), stamp.clock());
      case List<?> list -> list.stream().map(this::rewritten).toList();
      case Optional<?> optional -> optional.map(this::rewritten);
      case Record record when record.getClass().getName().startsWith(DATA) -> rewritten(record);
      default -> value;
    };
  }

  private Record rewritten(Record record) {
    Form form = FORMS.get(record.getClass());
    Object[] values = new Object[form.parts().size()];
    boolean changed = false;
    try {
      for (int i = 0; i < values.length; i++) {
        Object before = form.parts().get(i).invoke(record);
        values[i] = rewritten(before);
        changed |= !values[i].equals(before);
      }
      return changed ? (Record) form.maker().newInstance(values) : record;
    } catch (InvocationTargetException e) {
      throw new IllegalArgumentException(
          record.getClass().getSimpleName() + " cannot have other frames: " + e.getCause().getMessage(), e);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("a data type is no public record: " + record.getClass().getName(), e);
    }
  }
}
