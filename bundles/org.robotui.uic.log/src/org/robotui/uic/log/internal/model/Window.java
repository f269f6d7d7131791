package org.robotui.uic.log.internal.model;

import java.util.AbstractList;
import java.util.List;
import java.util.RandomAccess;

/** What a {@link Chunks} held at a moment; immutable, for all threads. */
final class Window<T> extends AbstractList<T> implements RandomAccess {
  private final List<Object[]> chunks;
  private final int start;
  private final int size;

  Window(List<Object[]> chunks, int start, int size) {
    this.chunks = chunks;
    this.start = start;
    this.size = size;
  }

  @Override
  @SuppressWarnings("unchecked") // chunks are filled by Chunks<T> alone
  public T get(int index) {
    java.util.Objects.checkIndex(index, size);
    int at = start + index;
    return (T) chunks.get(at / Chunks.CHUNK)[at % Chunks.CHUNK];
  }

  @Override
  public int size() {
    return size;
  }
}
