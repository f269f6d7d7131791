package org.robotui.message;

import java.util.List;

/**
 * Writes an array of messages.
 *
 * @param element writes one of them
 * @param field for errors
 * @param length of the definition, or as {@link LengthBounds} has it
 */
record ListWriter(BoundWriter element, String field, int length) {

  void write(List<?> values, FieldWriter out) {
    new ArrayWriter(field, length, 1).start(values.size(), out);
    for (Object each : values) {
      element.write(each, out);
    }
  }
}
