package org.robotui.message;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.AbstractList;
import java.util.Objects;
import java.util.RandomAccess;
import java.util.function.BiFunction;

/**
 * The elements of an array that are made when asked for, from the bytes of a checked message.
 *
 * @param <T> the Java value of an element
 */
final class LazyList<T> extends AbstractList<T> implements RandomAccess {

  private final ByteBuffer bytes;
  private final int[] starts;
  private final int first;
  private final int size;
  private final int stride;
  private final BiFunction<ByteBuffer, Integer, T> maker;

  private LazyList(ByteBuffer bytes, int[] starts, int first, int size, int stride,
      BiFunction<ByteBuffer, Integer, T> maker) {
    this.bytes = bytes;
    this.starts = starts;
    this.first = first;
    this.size = size;
    this.stride = stride;
    this.maker = maker;
  }

  static LazyList<DynamicMessage> messages(Layout.Field field, ByteBuffer bytes, int at) throws MessageException {
    return of(field, bytes, at, (b, start) -> DynamicMessage.at(field.nested(), b, start));
  }

  static LazyList<String> texts(Layout.Field field, ByteBuffer bytes, int at) throws MessageException {
    return of(field, bytes, at, LazyList::text);
  }

  private static <T> LazyList<T> of(Layout.Field field, ByteBuffer bytes, int at,
      BiFunction<ByteBuffer, Integer, T> maker) throws MessageException {
    LayoutWalk walk = new LayoutWalk(bytes);
    int size = walk.count(field, at);
    int first = walk.firstElement(field, at);
    int[] starts = new int[field.fixedElement() ? 0 : size];
    if (!field.fixedElement()) {
      walk.skipElements(field, first, size, starts);
    }
    return new LazyList<>(bytes, starts, first, size, (int) field.element(), maker);
  }

  static String text(ByteBuffer bytes, int at) {
    byte[] utf8 = new byte[bytes.getInt(at)];
    bytes.get(at + Integer.BYTES, utf8);
    return new String(utf8, StandardCharsets.UTF_8);
  }

  @Override
  public T get(int index) {
    Objects.checkIndex(index, size);
    return maker.apply(bytes, starts.length == 0 ? first + index * stride : starts[index]);
  }

  @Override
  public int size() {
    return size;
  }
}
