package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Locator;

/** Reads what submessages and parameters consist of, from the position of a buffer in its byte order. */
final class WireInput {

  /** No writer gets that far; up to here one may add to a number without a thought. */
  static final long MAX_SEQUENCE = 1L << 62;

  private static final int MAX_LOCATORS = 32;

  private static final int LOCATOR_BYTES = 24;

  private WireInput() {}

  static void need(ByteBuffer in, int bytes, String what) throws WireException {
    if (in.remaining() < bytes) {
      throw new WireException("%s takes %d bytes, here are %d".formatted(what, bytes, in.remaining()));
    }
  }

  /** Octets have no byte order. */
  private static long octets8(ByteBuffer in) {
    long value = in.getLong();
    return in.order() == ByteOrder.BIG_ENDIAN ? value : Long.reverseBytes(value);
  }

  private static int octets4(ByteBuffer in) {
    int value = in.getInt();
    return in.order() == ByteOrder.BIG_ENDIAN ? value : Integer.reverseBytes(value);
  }

  static GuidPrefix prefix(ByteBuffer in) throws WireException {
    need(in, GuidPrefix.BYTES, "a GUID prefix");
    return new GuidPrefix(octets8(in), octets4(in));
  }

  static EntityId entity(ByteBuffer in) throws WireException {
    need(in, 4, "an entity id");
    return new EntityId(octets4(in));
  }

  static Guid guid(ByteBuffer in) throws WireException {
    need(in, Guid.BYTES, "a GUID");
    return new Guid(prefix(in), entity(in));
  }

  /** The number of a sample. */
  static long sequence(ByteBuffer in) throws WireException {
    long number = number(in);
    if (number < 1) {
      throw new WireException("sequence number " + number);
    }
    return number;
  }

  /** From 0 on, as the end before the first sample. */
  static long number(ByteBuffer in) throws WireException {
    need(in, 8, "a sequence number");
    long number = (long) in.getInt() << 32 | Integer.toUnsignedLong(in.getInt());
    if (number < 0 || number > MAX_SEQUENCE) {
      throw new WireException("sequence number " + number);
    }
    return number;
  }

  static long unsigned(ByteBuffer in) throws WireException {
    need(in, 4, "a number");
    return Integer.toUnsignedLong(in.getInt());
  }

  static SequenceSet sequenceSet(ByteBuffer in) throws WireException {
    return set(in, number(in));
  }

  static SequenceSet fragmentSet(ByteBuffer in) throws WireException {
    return set(in, unsigned(in));
  }

  private static SequenceSet set(ByteBuffer in, long base) throws WireException {
    long bits = unsigned(in);
    if (bits > SequenceSet.MOST) {
      throw new WireException("a set of " + bits + " numbers");
    }
    int[] words = new int[(int) (bits + 31) / 32];
    need(in, words.length * 4, "a set of " + bits + " numbers");
    for (int i = 0; i < words.length; i++) {
      words[i] = in.getInt();
    }
    if (bits % 32 != 0) {
      words[words.length - 1] &= -1 << 32 - bits % 32; // what is beyond says nothing
    }
    return new SequenceSet(base, (int) bits, words);
  }

  static Locator locator(ByteBuffer in) throws WireException {
    need(in, LOCATOR_BYTES, "a locator");
    return new Locator(in.getInt(), in.getInt(), octets8(in), octets8(in));
  }

  static List<Locator> locators(ByteBuffer in) throws WireException {
    long count = unsigned(in);
    if (count > MAX_LOCATORS) {
      throw new WireException(count + " locators");
    }
    List<Locator> locators = new ArrayList<>();
    for (long i = 0; i < count; i++) {
      locators.add(locator(in));
    }
    return locators;
  }

  /** Without its kind: the form of the first versions. Its address is a number. */
  static Locator locatorIp4(ByteBuffer in) throws WireException {
    need(in, 8, "an address and a port");
    long address = Integer.toUnsignedLong(in.getInt());
    return new Locator(Locator.UDP_V4, in.getInt(), 0, address);
  }
}
