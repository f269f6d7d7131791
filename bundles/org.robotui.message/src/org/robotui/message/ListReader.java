package org.robotui.message;

import java.util.ArrayList;
import java.util.List;

/**
 * Reads an array of messages.
 *
 * @param element reads one of them
 * @param field for errors
 * @param length of the definition, or as {@link LengthBounds} has it
 * @param size the fewest bytes of an element
 */
record ListReader(BoundReader element, String field, int length, long size) {

  List<Object> read(FieldReader in) throws MessageException {
    int count = in.count(field, length, size);
    List<Object> values = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      try {
        values.add(element.read(in));
      } catch (MessageException e) {
        throw e.within("[" + i + "]").within(field);
      }
    }
    return values;
  }
}
