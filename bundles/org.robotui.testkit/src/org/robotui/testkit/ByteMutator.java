package org.robotui.testkit;

import java.util.Arrays;
import java.util.Random;

/** Damages bytes as networks and hostile peers do: always the same for one seed. Used by one thread. */
public final class ByteMutator {

  private static final byte[] EXTREME = {0, 1, -1, 127, -128};

  private final Random random;

  /**
   * Nothing damaged yet.
   *
   * @param seed where the random numbers begin
   */
  public ByteMutator(long seed) {
    random = new Random(seed);
  }

  /**
   * What it is random by.
   *
   * @return the same object always
   */
  public Random random() {
    return random;
  }

  /**
   * A damaged copy.
   *
   * @param bytes stay as they are
   * @return another length or other bytes
   */
  public byte[] mutate(byte[] bytes) {
    byte[] mutated = bytes.clone();
    for (int times = 1 + random.nextInt(4); times > 0; times--) {
      mutated = once(mutated);
    }
    return mutated;
  }

  private byte[] once(byte[] bytes) {
    if (bytes.length == 0) {
      return new byte[random.nextInt(30)];
    }
    int at = random.nextInt(bytes.length);
    switch (random.nextInt(7)) {
      case 0 -> bytes[at] = (byte) random.nextInt();
      case 1 -> bytes[at] ^= (byte) (1 << random.nextInt(8));
      case 2 -> extreme(bytes, at, 4);
      case 3 -> extreme(bytes, at, 2);
      case 4 -> {
        return Arrays.copyOf(bytes, random.nextInt(bytes.length + 1));
      }
      case 5 -> {
        return Arrays.copyOf(bytes, bytes.length + random.nextInt(40));
      }
      default -> {
        return moved(bytes, at);
      }
    }
    return bytes;
  }

  /** Lengths are numbers of two or four bytes: extreme ones find what is not bounded. */
  private void extreme(byte[] bytes, int at, int size) {
    byte first = EXTREME[random.nextInt(EXTREME.length)];
    byte rest = EXTREME[random.nextInt(EXTREME.length)];
    int start = random.nextBoolean() ? at : at & -size;
    for (int i = start; i < Math.min(start + size, bytes.length); i++) {
      bytes[i] = i == start ? first : rest;
    }
  }

  /** A part stands twice, or is missing. */
  private byte[] moved(byte[] bytes, int at) {
    int size = random.nextInt(Math.min(60, bytes.length - at) + 1);
    boolean twice = random.nextBoolean();
    byte[] moved = new byte[twice ? bytes.length + size : bytes.length - size];
    System.arraycopy(bytes, 0, moved, 0, at);
    if (twice) {
      System.arraycopy(bytes, at, moved, at, size);
      System.arraycopy(bytes, at, moved, at + size, bytes.length - at);
    } else {
      System.arraycopy(bytes, at + size, moved, at, bytes.length - at - size);
    }
    return moved;
  }
}
