package org.robotui.bridge.internal.change;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
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
    RecordComponent[] components = record.getClass().getRecordComponents();
    Class<?>[] types = new Class<?>[components.length];
    Object[] values = new Object[components.length];
    boolean changed = false;
    try {
      for (int i = 0; i < components.length; i++) {
        Object before = components[i].getAccessor().invoke(record);
        types[i] = components[i].getType();
        values[i] = rewritten(before);
        changed |= !values[i].equals(before);
      }
      Constructor<? extends Record> constructor = record.getClass().getDeclaredConstructor(types);
      return changed ? constructor.newInstance(values) : record;
    } catch (InvocationTargetException e) {
      throw new IllegalArgumentException(
          record.getClass().getSimpleName() + " cannot have other frames: " + e.getCause().getMessage(), e);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("a data type is no public record: " + record.getClass().getName(), e);
    }
  }
}
