package org.robotui.yarp.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;

/** A message in datagrams: each begins with a checksum of what follows, and with its place in the message. */
public final class DatagramPieces {
  public static final int HEAD = 8;
  /** As long as those of YARP are, with their head. */
  public static final int LONGEST = 65_499;
  /** The place of datagrams that only wake up who receives. */
  static final int NOWHERE = -1;

  private DatagramPieces() {}

  /** The datagrams of a message, none of them longer than told. */
  public static List<byte[]> split(byte[] message, int longest) {
    List<byte[]> pieces = new ArrayList<>();
    int each = longest - HEAD;
    for (int at = 0; at < message.length; at += each) {
      pieces.add(piece(message, at, Math.min(each, message.length - at), pieces.size()));
    }
    return pieces;
  }

  private static byte[] piece(byte[] message, int at, int length, int place) {
    return ByteBuffer.allocate(HEAD + length).order(ByteOrder.LITTLE_ENDIAN)
        .putInt((int) sum(ByteBuffer.wrap(message, at, length))).putInt(place).put(message, at, length).array();
  }

  static long sum(ByteBuffer bytes) {
    CRC32 sum = new CRC32();
    sum.update(bytes);
    return sum.getValue();
  }
}
