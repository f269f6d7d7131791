package org.robotui.rtps.internal.wire;

import java.util.Arrays;

/**
 * Sequence or fragment numbers that lie close together: what acknowledgements ask for and gaps name.
 *
 * @param base all before it are not in the set
 * @param bits how many numbers from the base on the set speaks of, at most 256
 * @param words the numbers that are in it, the base as the highest bit of the first word; nobody changes them
 */
public record SequenceSet(long base, int bits, int[] words) {

  /** The most numbers that one set speaks of. */
  public static final int MOST = 256;

  /** Checks the bounds. */
  public SequenceSet {
    if (base < 0 || bits < 0 || bits > MOST || words.length != (bits + 31) / 32) {
      throw new IllegalArgumentException("a set of %d numbers from %d on in %d words".formatted(bits, base,
          words.length));
    }
  }

  /** A set without numbers. */
  public static SequenceSet none(long base) {
    return new SequenceSet(base, 0, new int[0]);
  }

  /** Whether a number from the base on is in the set. */
  public boolean contains(long number) {
    long index = number - base;
    return index >= 0 && index < bits && (words[(int) (index >> 5)] & 1 << 31 - (int) (index & 31)) != 0;
  }

  /** The end of what it speaks of. */
  public long end() {
    return base + bits;
  }

  /** Whether no number is in it. */
  public boolean isEmpty() {
    for (int word : words) {
      if (word != 0) {
        return false;
      }
    }
    return true;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof SequenceSet set && base == set.base && bits == set.bits && Arrays.equals(words, set.words);
  }

  @Override
  public int hashCode() {
    return 31 * (31 * Long.hashCode(base) + bits) + Arrays.hashCode(words);
  }

  /** The base, and the numbers that are in it. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder().append(base).append("{");
    for (long number = base; number < end(); number++) {
      text.append(contains(number) ? " " + number : "");
    }
    return text.append(" }/").append(bits).toString();
  }

  /** Collects numbers from a base on. */
  public static final class Builder {
    private final long base;
    private final int[] words = new int[MOST / Integer.SIZE];
    private int bits;

    /** Begins at a base. */
    public Builder(long base) {
      this.base = base;
    }

    /** Adds a number, if there is room for it. */
    public Builder add(long number) {
      long index = number - base;
      if (index >= 0 && index < MOST) {
        words[(int) (index >> 5)] |= 1 << 31 - (int) (index & 31);
        bits = Math.max(bits, (int) index + 1);
      }
      return this;
    }

    /** The set. */
    public SequenceSet build() {
      return new SequenceSet(base, bits, Arrays.copyOf(words, (bits + 31) / 32));
    }
  }
}
