package org.robotui.message;

import java.lang.invoke.MethodHandles;
import java.lang.reflect.Array;
import java.lang.reflect.RecordComponent;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * What stands in a record for a field that another version of the message lacks: zero, empty, or a record of those.
 *
 * @param lookup may make the records
 */
record Nothing(MethodHandles.Lookup lookup) {

  Object of(RecordComponent component, Layout.Field field) {
    Class<?> type = component.getType();
    int length = field.type().length() * (type == List.class ? 1 : width(field));
    if (type.isPrimitive()) {
      return Array.get(Array.newInstance(type, 1), 0);
    }
    if (type.isArray()) {
      return Array.newInstance(type.componentType(), length);
    }
    if (type.isRecord()) {
      return record(type, field.nested());
    }
    if (type == List.class) {
      return length == 0 ? List.of() : Collections.nCopies(length, element(component, field));
    }
    return type == String.class ? "" : ByteBuffer.allocate(length).asReadOnlyBuffer();
  }

  private Object element(RecordComponent component, Layout.Field field) {
    return field.nested() == null ? "" : record(JavaForm.element(component).orElseThrow(), field.nested());
  }

  private static int width(Layout.Field field) {
    return field.nested() == null ? 1 : JavaForm.flat(field.nested()).map(JavaForm.Flat::width).orElse(1);
  }

  private Object record(Class<?> type, Layout layout) {
    Object[] components = Arrays.stream(type.getRecordComponents())
        .map(c -> of(c, BoundRecord.field(layout, c))).toArray();
    try {
      return BoundRecord.constructor(lookup, type).invokeWithArguments(components);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalArgumentException(type.getName() + " cannot be made of zeros", e);
    }
  }
}
