package org.robotui.message;

import java.lang.invoke.MethodHandle;
import java.util.ArrayList;
import java.util.List;

/**
 * Reads an array of messages.
 *
 * @param element reads one of them
 * @param field for errors
 * @param length of the definition, or as {@link Bounds} has it
 * @param size the fewest bytes of an element
 */
record ListReader(MethodHandle element, String field, int length, long size) {

  List<Object> read(FieldReader in) throws Throwable {
    int count = in.count(field, length, size);
    List<Object> values = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      try {
        values.add((Object) element.invokeExact(in));
      } catch (MessageException e) {
        throw e.within("[" + i + "]").within(field);
      }
    }
    return values;
  }
}
