package org.robotui.uic.log.internal.model;

import java.util.ArrayList;
import java.util.List;

/**
 * A queue that is read by index and of which a picture can be taken at little cost: pictures share the chunks, of which
 * only places that no picture shows are written. One thread writes.
 */
final class Chunks<T> {
  static final int CHUNK = 512;

  private final List<Object[]> chunks = new ArrayList<>();
  private int start;
  private int size;
  private boolean firstShown;
  private boolean lastShown;

  int size() {
    return size;
  }

  void add(T value) {
    int at = start + size;
    if (at == chunks.size() * CHUNK) {
      chunks.add(new Object[CHUNK]);
    }
    chunks.get(at / CHUNK)[at % CHUNK] = value;
    size++;
    lastShown = false;
  }

  @SuppressWarnings("unchecked") // only T is put in
  T get(int index) {
    java.util.Objects.checkIndex(index, size);
    int at = start + index;
    return (T) chunks.get(at / CHUNK)[at % CHUNK];
  }

  /** Puts another in place of the last; pictures taken before keep the old one. */
  void replaceLast(T value) {
    int at = start + size - 1;
    if (lastShown) {
      chunks.set(at / CHUNK, chunks.get(at / CHUNK).clone());
      lastShown = false;
      firstShown = firstShown && chunks.size() > 1;
    }
    chunks.get(at / CHUNK)[at % CHUNK] = value;
  }

  /** Forgets the oldest, which is not held any longer but by pictures. */
  T removeFirst() {
    T first = get(0);
    if (firstShown) {
      chunks.set(0, chunks.getFirst().clone());
      firstShown = false;
      lastShown = lastShown && chunks.size() > 1;
    }
    chunks.getFirst()[start] = null;
    start++;
    size--;
    if (start == CHUNK) {
      chunks.removeFirst();
      start = 0;
      firstShown = true;
    }
    return first;
  }

  void clear() {
    chunks.clear();
    start = 0;
    size = 0;
  }

  List<T> picture() {
    firstShown = true;
    lastShown = true;
    return new Window<>(List.copyOf(chunks), start, size);
  }
}
