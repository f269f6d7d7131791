package org.robotui.message;

import java.nio.ByteBuffer;

/** Finds where fields end, checking every length against the bytes that are there. Allocates nothing. */
final class LayoutWalk {

  private final ByteBuffer bytes;

  /** Walks bytes from 0 to the buffer's limit. */
  LayoutWalk(ByteBuffer bytes) {
    this.bytes = bytes;
  }

  /** Checks a whole message. */
  void check(Layout layout) throws MessageException {
    int end = skip(layout, 0);
    if (end < bytes.limit()) {
      throw new MessageException(
          (bytes.limit() - end) + " bytes are left after the last field", "", end);
    }
  }

  int skip(Layout layout, int at) throws MessageException {
    if (layout.fixedSize() && layout.minSize() <= left(at)) {
      return at + (int) layout.minSize();
    }
    int end = at;
    for (Layout.Field each : layout.fields()) {
      end = skip(each, end);
    }
    return end;
  }

  int skip(Layout.Field field, int at) throws MessageException {
    if (field.isFixed() && field.minSize() <= left(at)) {
      return at + (int) field.minSize();
    }
    try {
      return skipValues(field, at);
    } catch (MessageException e) {
      throw e.within(field.name());
    }
  }

  private int skipValues(Layout.Field field, int at) throws MessageException {
    if (field.type().arity() == FieldType.Arity.ONE) {
      return skipElement(field, at);
    }
    int count = count(field, at);
    int first = firstElement(field, at);
    return field.fixedElement()
        ? first + (int) (count * field.element())
        : skipElements(field, first, count, new int[0]);
  }

  /** Skips elements and notes where the first ones start. */
  int skipElements(Layout.Field field, int first, int count, int[] starts) throws MessageException {
    int end = first;
    for (int i = 0; i < count; i++) {
      if (i < starts.length) {
        starts[i] = end;
      }
      try {
        end = skipElement(field, end);
      } catch (MessageException e) {
        throw e.within("[" + i + "]");
      }
    }
    return end;
  }

  /** The number of elements of an array field at the given place, which fit into the bytes that are left. */
  int count(Layout.Field field, int at) throws MessageException {
    boolean fixed = field.type().arity() == FieldType.Arity.FIXED;
    if (!fixed) {
      need(Integer.BYTES, at);
    }
    long count = fixed ? field.type().length() : Integer.toUnsignedLong(bytes.getInt(at));
    long room = field.element() == 0
        ? Layout.MAX_EMPTY_ELEMENTS
        : left(firstElement(field, at)) / field.element();
    if (count > room) {
      throw new MessageException("a length of " + count + " does not fit into the remaining "
          + left(firstElement(field, at)) + " bytes", "", at);
    }
    return (int) count;
  }

  int firstElement(Layout.Field field, int at) {
    return field.type().arity() == FieldType.Arity.VARIABLE ? at + Integer.BYTES : at;
  }

  private int skipElement(Layout.Field field, int at) throws MessageException {
    if (field.nested() != null) {
      return skip(field.nested(), at);
    }
    if (!field.primitive().isText()) {
      need(field.element(), at);
      return at + (int) field.element();
    }
    need(Integer.BYTES, at);
    long length = Integer.toUnsignedLong(bytes.getInt(at));
    if (length > left(at + Integer.BYTES)) {
      throw new MessageException("a text of " + length + " bytes does not fit into the remaining "
          + left(at + Integer.BYTES) + " bytes", "", at);
    }
    return at + Integer.BYTES + (int) length;
  }

  private void need(long size, int at) throws MessageException {
    if (size > left(at)) {
      throw new MessageException(size + " bytes are needed and " + left(at) + " are left", "", at);
    }
  }

  private int left(int at) {
    return bytes.limit() - at;
  }
}
