package org.robotui.gl.internal.splat;

import java.util.Arrays;

/** Triples of numbers, each kept once, in the order in which they were first seen. */
final class Welds {
  private static final int FIRST = 256;
  private static final int EMPTY = -1;
  private static final int MIXER = 0x9e3779b1;

  private int[] triples = new int[3 * FIRST];
  private int[] slots = new int[2 * FIRST];
  private int size;

  Welds() {
    Arrays.fill(slots, EMPTY);
  }

  /** The number of a triple, which becomes known by this. */
  int number(int a, int b, int c) {
    int slot = slot(a, b, c);
    if (slots[slot] == EMPTY) {
      if (2 * size == slots.length) {
        grow();
        slot = slot(a, b, c);
      }
      slots[slot] = size;
      triples[3 * size] = a;
      triples[3 * size + 1] = b;
      triples[3 * size + 2] = c;
      size++;
    }
    return slots[slot];
  }

  int size() {
    return size;
  }

  /** One of the three numbers of a triple. */
  int get(int number, int which) {
    return triples[3 * number + which];
  }

  private int slot(int a, int b, int c) {
    int hash = ((a * MIXER ^ b) * MIXER ^ c) * MIXER;
    int slot = (hash ^ hash >>> 15) & slots.length - 1;
    while (slots[slot] != EMPTY && !holds(slots[slot], a, b, c)) {
      slot = slot + 1 & slots.length - 1;
    }
    return slot;
  }

  private boolean holds(int number, int a, int b, int c) {
    return triples[3 * number] == a && triples[3 * number + 1] == b && triples[3 * number + 2] == c;
  }

  private void grow() {
    triples = Arrays.copyOf(triples, 2 * triples.length);
    slots = new int[2 * slots.length];
    Arrays.fill(slots, EMPTY);
    for (int i = 0; i < size; i++) {
      slots[slot(get(i, 0), get(i, 1), get(i, 2))] = i;
    }
  }
}
