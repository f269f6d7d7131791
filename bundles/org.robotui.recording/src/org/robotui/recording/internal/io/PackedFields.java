package org.robotui.recording.internal.io;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/** Takes fields one after another from a range of bytes, little-endian, and never from outside of it. */
public final class PackedFields {

  private final ByteBuffer bytes;

  public PackedFields(byte[] bytes, int from, int to) {
    this.bytes = ByteBuffer.wrap(bytes, from, to - from).order(ByteOrder.LITTLE_ENDIAN);
  }

  public boolean hasMore() {
    return bytes.hasRemaining();
  }

  public int remaining() {
    return bytes.remaining();
  }

  /** Where the next field begins in the array. */
  public int position() {
    return bytes.position();
  }

  public int u8(String what) throws MalformedRecord {
    return need(1, what).get() & 0xff;
  }

  public int u16(String what) throws MalformedRecord {
    return need(Short.BYTES, what).getShort() & 0xffff;
  }

  public long u32(String what) throws MalformedRecord {
    return need(Integer.BYTES, what).getInt() & 0xffff_ffffL;
  }

  public long i64(String what) throws MalformedRecord {
    return need(Long.BYTES, what).getLong();
  }

  /** A length, a place or a count: as signed numbers they are never below 0. */
  public long size(String what) throws MalformedRecord {
    long size = i64(what);
    if (size < 0) {
      throw new MalformedRecord(what + " is " + Long.toUnsignedString(size));
    }
    return size;
  }

  /** A text after its length in 32 bits. */
  public String text(String what) throws MalformedRecord {
    return new String(bytes(u32(what), what), StandardCharsets.UTF_8);
  }

  /** Bytes after their length in 32 bits. */
  public byte[] block(String what) throws MalformedRecord {
    return bytes(u32(what), what);
  }

  /** A range of a length in 32 bits that comes before it. */
  public PackedFields part(String what) throws MalformedRecord {
    int length = fitting(u32(what), what);
    int from = bytes.position();
    bytes.position(from + length);
    return new PackedFields(bytes.array(), from, from + length);
  }

  public Map<String, String> texts(String what) throws MalformedRecord {
    Map<String, String> texts = new LinkedHashMap<>();
    PackedFields part = part(what);
    while (part.hasMore()) {
      texts.put(part.text(what), part.text(what));
    }
    return texts;
  }

  /** Goes over bytes, and says where they began. */
  public int skip(long length, String what) throws MalformedRecord {
    int from = bytes.position();
    bytes.position(from + fitting(length, what));
    return from;
  }

  private byte[] bytes(long length, String what) throws MalformedRecord {
    byte[] taken = new byte[fitting(length, what)];
    bytes.get(taken);
    return taken;
  }

  private int fitting(long length, String what) throws MalformedRecord {
    if (length < 0 || length > bytes.remaining()) {
      throw new MalformedRecord(
          what + " has " + Long.toUnsignedString(length) + " bytes where " + bytes.remaining() + " are left");
    }
    return (int) length;
  }

  private ByteBuffer need(int length, String what) throws MalformedRecord {
    fitting(length, what);
    return bytes;
  }
}
