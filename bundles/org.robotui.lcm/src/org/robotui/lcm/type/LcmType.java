package org.robotui.lcm.type;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HexFormat;

/** A message type that can be encoded and decoded. Immutable. */
public final class LcmType {

  private final Layout layout;
  private final long fingerprint;

  LcmType(Layout layout, long fingerprint) {
    this.layout = layout;
    this.fingerprint = fingerprint;
  }

  /**
   * The full name.
   *
   * @return with the package
   */
  public String name() {
    return layout.type();
  }

  /**
   * The number with which each message of this type starts.
   *
   * @return as {@code lcm-gen} computes it
   */
  public long fingerprint() {
    return fingerprint;
  }

  /**
   * The declaration.
   *
   * @return members and constants
   */
  public TypeDefinition.Struct definition() {
    return layout.definition();
  }

  /**
   * Decodes a message. Bytes after its end are left alone, as by the decoders of {@code lcm-gen}.
   *
   * @param message the bytes, from position to limit, which the record goes on to read: nobody may change them
   * @return the record
   * @throws RecordException if it is of another type or damaged
   */
  public LcmRecord decode(ByteBuffer message) throws RecordException {
    long found = fingerprintOf(message);
    if (found != fingerprint) {
      throw new RecordException(name(), "the fingerprint is " + hex(found) + " and not " + hex(fingerprint)
          + ": the sender means another type, or another version of it", "", 0);
    }
    return RecordReader.read(layout, message.slice().asReadOnlyBuffer().order(ByteOrder.BIG_ENDIAN), Long.BYTES);
  }

  /**
   * Encodes a message.
   *
   * @param record a record of this type
   * @return the bytes, with the fingerprint
   * @throws IllegalArgumentException if the record is of another type
   */
  public ByteBuffer encode(LcmRecord record) {
    if (!record.type().equals(name())) {
      throw new IllegalArgumentException("a record of " + record.type() + " is no " + name());
    }
    return RecordWriter.write(fingerprint, record);
  }

  /**
   * Starts a new record.
   *
   * @return a builder with zeros and empty arrays
   */
  public RecordBuilder builder() {
    return new RecordBuilder(layout);
  }

  /**
   * Starts a new record for a member of this type, or of a struct within it.
   *
   * @param member a path of names, such as {@code pose.position}
   * @return a builder for what the member holds, one element if it is an array
   * @throws IllegalArgumentException if the path leads to no struct
   */
  public RecordBuilder builderFor(String member) {
    Layout at = layout;
    for (String name : member.split("\\.")) {
      int index = at.indexOf(name);
      if (index < 0 || !(at.slots().get(index).element() instanceof Slot.Struct struct)) {
        throw new IllegalArgumentException("'" + name + "' is no struct in " + at.type());
      }
      at = struct.layout();
    }
    return new RecordBuilder(at);
  }

  static long fingerprintOf(ByteBuffer message) throws RecordException {
    if (message.remaining() < Long.BYTES) {
      throw new RecordException("unknown type", "a message of " + message.remaining() + " bytes has no fingerprint", "",
          0);
    }
    return message.slice().order(ByteOrder.BIG_ENDIAN).getLong(0);
  }

  static String hex(long fingerprint) {
    return "0x" + HexFormat.of().toHexDigits(fingerprint);
  }

  @Override
  public String toString() {
    return name() + " " + hex(fingerprint);
  }
}
