package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Locator;

/** Writes what submessages and parameters consist of, at the position of a buffer in its byte order. */
final class WireOutput {

  private WireOutput() {}

  private static void octets8(ByteBuffer out, long value) {
    out.putLong(out.order() == ByteOrder.BIG_ENDIAN ? value : Long.reverseBytes(value));
  }

  private static void octets4(ByteBuffer out, int value) {
    out.putInt(out.order() == ByteOrder.BIG_ENDIAN ? value : Integer.reverseBytes(value));
  }

  static void pair(ByteBuffer out, int value) {
    out.put((byte) (value >> 8)).put((byte) value);
  }

  static void prefix(ByteBuffer out, GuidPrefix prefix) {
    octets8(out, prefix.high());
    octets4(out, prefix.low());
  }

  static void entity(ByteBuffer out, EntityId entity) {
    octets4(out, entity.value());
  }

  static void guid(ByteBuffer out, Guid guid) {
    prefix(out, guid.prefix());
    entity(out, guid.entity());
  }

  static void sequence(ByteBuffer out, long number) {
    out.putInt((int) (number >> 32)).putInt((int) number);
  }

  static void sequenceSet(ByteBuffer out, SequenceSet set) {
    sequence(out, set.base());
    words(out, set);
  }

  static void fragmentSet(ByteBuffer out, SequenceSet set) {
    out.putInt((int) set.base());
    words(out, set);
  }

  private static void words(ByteBuffer out, SequenceSet set) {
    out.putInt(set.bits());
    for (int word : set.words()) {
      out.putInt(word);
    }
  }

  static void locator(ByteBuffer out, Locator locator) {
    out.putInt(locator.kind()).putInt(locator.port());
    octets8(out, locator.high());
    octets8(out, locator.low());
  }

  static void locators(ByteBuffer out, List<Locator> locators) {
    out.putInt(locators.size());
    locators.forEach(locator -> locator(out, locator));
  }

  /** Zeros up to a multiple of four bytes from a position on. */
  static void align(ByteBuffer out, int from) {
    while ((out.position() - from & 3) != 0) {
      out.put((byte) 0);
    }
  }
}
