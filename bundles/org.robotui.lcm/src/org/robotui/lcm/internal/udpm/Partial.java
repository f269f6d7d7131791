package org.robotui.lcm.internal.udpm;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Optional;

/** A message of which fragments are missing. Its memory grows with what came, not with what was announced. */
final class Partial {

  /** So much is made at once, and so far may fragments run ahead of each other. */
  private static final int AHEAD = 1 << 20;

  private final int size;
  private final int count;
  private final BitSet seen = new BitSet();
  private Optional<String> channel = Optional.empty();
  private boolean wanted = true;
  private byte[] bytes = new byte[0];
  private int received;
  private int fragments;
  private long last;

  Partial(Fragment first) {
    this.size = first.size();
    this.count = first.count();
  }

  boolean isOf(Fragment fragment) {
    return fragment.size() == size && fragment.count() == count;
  }

  /** Adds a fragment; one that came already is left out. */
  void add(Fragment fragment, ByteBuffer data, long now) throws DatagramException {
    int length = data.remaining();
    if (length > size - fragment.offset()) {
      throw new DatagramException("a fragment of " + length + " bytes at byte " + fragment.offset() + " of " + size);
    }
    if (seen.get(fragment.number())) {
      return;
    }
    seen.set(fragment.number());
    fragments++;
    last = now;
    if (wanted) {
      makeRoom(fragment.offset() + length);
      data.get(bytes, fragment.offset(), length);
    }
    received += length;
    if (received > size || isComplete() && received != size) {
      throw new DatagramException("the fragments of a message of " + size + " bytes have " + received);
    }
  }

  private void makeRoom(int end) throws DatagramException {
    if (end <= bytes.length) {
      return;
    }
    long most = 2L * received + AHEAD;
    if (end - Wire.MOST_DATAGRAM > most) {
      throw new DatagramException(
          "a fragment up to byte " + end + " of a message of which " + received + " bytes came");
    }
    bytes = Arrays.copyOf(bytes, (int) Math.min(size, Math.max(end, most)));
  }

  /** Says what the first fragment says. */
  void named(String name, boolean isWanted) {
    channel = Optional.of(name);
    wanted = isWanted;
    if (!wanted) {
      bytes = new byte[0];
    }
  }

  boolean isComplete() {
    return fragments == count;
  }

  /** Whether its channel has a subscription, as far as is known. */
  boolean isWanted() {
    return wanted;
  }

  /** The memory it holds. */
  int held() {
    return bytes.length + seen.size() / Byte.SIZE;
  }

  /** When the last fragment came. */
  long last() {
    return last;
  }

  /** The channel of a complete message. */
  String channel() {
    return channel.orElseThrow();
  }

  /** The bytes of a complete message. */
  ByteBuffer data() {
    return ByteBuffer.wrap(bytes, 0, size);
  }
}
