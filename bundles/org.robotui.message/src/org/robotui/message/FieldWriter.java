package org.robotui.message;

import java.nio.ByteBuffer;

/**
 * Writes the fields of one message in the order of its definition, whatever the encoding. An array of variable length
 * is preceded by {@link #array}. Not for use by several threads at once.
 */
public interface FieldWriter {

  /** A bool. */
  FieldWriter bool(boolean value);

  /** The low eight bits. */
  FieldWriter u8(int value);

  /** The low 16 bits. */
  FieldWriter i16(int value);

  /** 32 bits of a signed or an unsigned integer. */
  FieldWriter i32(int value);

  /** 64 bits of a signed or an unsigned integer. */
  FieldWriter i64(long value);

  /** IEEE single. */
  FieldWriter f32(float value);

  /** IEEE double. */
  FieldWriter f64(double value);

  /** A text. */
  FieldWriter string(String value);

  /** A text of wide characters. */
  FieldWriter wstring(String value);

  /** A time or a duration in nanoseconds. */
  FieldWriter stamp(long nanos);

  /** The length of an array of variable length, before its elements. */
  FieldWriter array(int count);

  /** The remaining bytes, whose position stays. */
  FieldWriter bytes(ByteBuffer source);

  /** Integers of 16 bits. */
  FieldWriter shorts(short[] values);

  /** Integers of 32 bits. */
  FieldWriter ints(int[] values);

  /** Integers of 64 bits. */
  FieldWriter longs(long[] values);

  /** IEEE singles. */
  FieldWriter floats(float[] values);

  /** IEEE doubles. */
  FieldWriter doubles(double[] values);

  /**
   * How much was written.
   *
   * @return the number of bytes so far
   */
  int size();

  /**
   * What was written, without copying it.
   *
   * @return a view in the byte order of the encoding that is valid until the next change of this writer
   */
  ByteBuffer view();
}
