package org.robotui.message;

import java.nio.ByteBuffer;
import java.util.List;

/**
 * Reads the fields of one message in the order of its definition, whatever the encoding. Every read is checked against
 * the bytes that are left before anything is allocated, and fails with an error that names the field. Arrays are read
 * with their length: that of the definition, {@link #SENT} where the length is sent with them, or {@code SENT - n}
 * where it is sent and may be n at most. An element may consist of several numbers ({@code width}), as a point does.
 * Not for use by several threads at once.
 */
public interface FieldReader {

  /** The length of arrays whose length is sent with them. */
  int SENT = -1;

  /** Any byte but 0 is true. */
  boolean bool(String field) throws MessageException;

  /** -128 to 127. */
  int int8(String field) throws MessageException;

  /** 0 to 255. */
  int uint8(String field) throws MessageException;

  /** A signed integer of 16 bits. */
  int int16(String field) throws MessageException;

  /** 0 to 65535. */
  int uint16(String field) throws MessageException;

  /** A signed integer of 32 bits. */
  int int32(String field) throws MessageException;

  /** 0 to 4294967295. */
  long uint32(String field) throws MessageException;

  /** A signed integer of 64 bits. */
  long int64(String field) throws MessageException;

  /** The bits of an unsigned integer of 64 bits. */
  long uint64(String field) throws MessageException;

  /** IEEE single. */
  float float32(String field) throws MessageException;

  /** IEEE double. */
  double float64(String field) throws MessageException;

  /** Nanoseconds since the epoch of the sender's clock. */
  long time(String field) throws MessageException;

  /** Nanoseconds. */
  long duration(String field) throws MessageException;

  /** A text; bytes that are no UTF-8 become replacement characters. */
  String string(String field) throws MessageException;

  /** A text of wide characters. */
  String wstring(String field) throws MessageException;

  /** Texts. */
  List<String> strings(String field, int length) throws MessageException;

  /** Texts of wide characters. */
  List<String> wstrings(String field, int length) throws MessageException;

  /** Elements of one byte, as a read-only slice of the message. */
  ByteBuffer bytes(String field, int length, int width) throws MessageException;

  /** Integers of 16 bits; unsigned ones as their bits. */
  short[] shorts(String field, int length, int width) throws MessageException;

  /** Integers of 32 bits; unsigned ones as their bits. */
  int[] ints(String field, int length, int width) throws MessageException;

  /** Integers of 64 bits; unsigned ones as their bits. */
  long[] longs(String field, int length, int width) throws MessageException;

  /** IEEE singles. */
  float[] floats(String field, int length, int width) throws MessageException;

  /** IEEE doubles. */
  double[] doubles(String field, int length, int width) throws MessageException;

  /**
   * The length of an array, sent before it.
   *
   * @param field for errors
   * @param element the fewest bytes of one element; elements without bytes are bounded by a number
   * @return the number of elements, which the bytes that are left can hold
   * @throws MessageException if they cannot
   */
  int count(String field, long element) throws MessageException;

  /**
   * The length of an array, where its definition says so or as it is sent.
   *
   * @param field for errors
   * @param length of the definition, {@link #SENT}, or {@code SENT - n} where at most n elements are sent
   * @param element the fewest bytes of one element
   * @return the number of elements; where it was sent, the bytes that are left can hold them
   * @throws MessageException if they cannot, or if there are more than the definition allows
   */
  int count(String field, int length, long element) throws MessageException;

  /**
   * Checks that the whole message was read.
   *
   * @throws MessageException if bytes are left
   */
  void end() throws MessageException;

  /**
   * Passes over values that nobody wants.
   *
   * @param field for errors
   * @param type of each of them
   * @param count how many there are
   * @throws MessageException if the message ends before
   */
  void skip(String field, Primitive type, int count) throws MessageException;
}
