package org.robotui.player.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Reads XDR as Player writes it: big endian, everything padded to four bytes, lengths before arrays. Every length is
 * checked first.
 */
public final class XdrReader {

  private final ByteBuffer in;

  /**
   * Reads a buffer from its position to its limit.
   *
   * @param in the bytes; its own position stays as it is
   */
  public XdrReader(ByteBuffer in) {
    this.in = in.slice().order(ByteOrder.BIG_ENDIAN);
  }

  /**
   * How much is left.
   *
   * @return the bytes that were not read
   */
  public int remaining() {
    return in.remaining();
  }

  /**
   * A signed number of four bytes.
   *
   * @return the number
   * @throws PlayerException if the bytes end before it
   */
  public int i32() throws PlayerException {
    need(Integer.BYTES);
    return in.getInt();
  }

  /**
   * An unsigned number of four bytes.
   *
   * @return the number
   * @throws PlayerException if the bytes end before it
   */
  public long u32() throws PlayerException {
    return Integer.toUnsignedLong(i32());
  }

  /**
   * A signed number of eight bytes.
   *
   * @return the number
   * @throws PlayerException if the bytes end before it
   */
  public long i64() throws PlayerException {
    need(Long.BYTES);
    return in.getLong();
  }

  /**
   * A small number, which takes four bytes as well.
   *
   * @param least the smallest it can be
   * @param most the largest it can be
   * @return the number
   * @throws PlayerException if the bytes end before it or it is another one
   */
  public int within(int least, int most) throws PlayerException {
    int value = i32();
    if (value < least || value > most) {
      throw new PlayerException(
          value + " is outside " + least + " to " + most + " at byte " + (in.position() - Integer.BYTES));
    }
    return value;
  }

  /**
   * A real number of four bytes.
   *
   * @return the number, possibly not finite
   * @throws PlayerException if the bytes end before it
   */
  public float f32() throws PlayerException {
    return Float.intBitsToFloat(i32());
  }

  /**
   * A real number of eight bytes.
   *
   * @return the number, possibly not finite
   * @throws PlayerException if the bytes end before it
   */
  public double f64() throws PlayerException {
    return Double.longBitsToDouble(i64());
  }

  /**
   * Signed numbers of four bytes.
   *
   * @param count how many
   * @return the numbers
   * @throws PlayerException if the bytes end before them
   */
  public int[] i32s(int count) throws PlayerException {
    int[] numbers = new int[needed(count, Integer.BYTES)];
    in.asIntBuffer().get(numbers);
    in.position(in.position() + count * Integer.BYTES);
    return numbers;
  }

  /**
   * Real numbers of four bytes.
   *
   * @param count how many
   * @return the numbers, possibly not finite
   * @throws PlayerException if the bytes end before them
   */
  public float[] f32s(int count) throws PlayerException {
    float[] numbers = new float[needed(count, Float.BYTES)];
    in.asFloatBuffer().get(numbers);
    in.position(in.position() + count * Float.BYTES);
    return numbers;
  }

  /**
   * Real numbers of eight bytes.
   *
   * @param count how many
   * @return the numbers, possibly not finite
   * @throws PlayerException if the bytes end before them
   */
  public double[] f64s(int count) throws PlayerException {
    double[] numbers = new double[needed(count, Double.BYTES)];
    in.asDoubleBuffer().get(numbers);
    in.position(in.position() + count * Double.BYTES);
    return numbers;
  }

  /**
   * How many elements follow.
   *
   * @param elementBytes the fewest bytes an element takes
   * @return the number; the bytes that are left can hold so many
   * @throws PlayerException if they cannot
   */
  public int count(int elementBytes) throws PlayerException {
    int at = in.position();
    long count = u32();
    if (count * elementBytes > in.remaining()) {
      throw new PlayerException(
          count + " elements of " + elementBytes + " bytes or more announced at byte " + at + ", but "
              + in.remaining() + " bytes follow");
    }
    return (int) count;
  }

  /**
   * The second count that XDR writes before the elements of an array.
   *
   * @param count the first
   * @throws PlayerException if it is another one
   */
  public void sameCount(int count) throws PlayerException {
    int at = in.position();
    long again = u32();
    if (again != count) {
      throw new PlayerException("an array has two lengths, " + count + " and " + again + " at byte " + at);
    }
  }

  /**
   * Bytes, and what pads them.
   *
   * @param count how many
   * @return the bytes without the padding
   * @throws PlayerException if they end before
   */
  public byte[] bytes(int count) throws PlayerException {
    need(count + padding(count));
    byte[] bytes = new byte[count];
    in.get(bytes);
    in.position(in.position() + padding(count));
    return bytes;
  }

  /**
   * Checks that everything was read.
   *
   * @throws PlayerException if bytes are left
   */
  public void end() throws PlayerException {
    if (in.hasRemaining()) {
      throw new PlayerException(in.remaining() + " bytes are left over at byte " + in.position());
    }
  }

  static int padding(int count) {
    return -count & 3;
  }

  /** The count, if there are so many. */
  private int needed(int count, int each) throws PlayerException {
    need((int) Math.min(Integer.MAX_VALUE, (long) count * each));
    return count;
  }

  private void need(int bytes) throws PlayerException {
    if (bytes < 0 || bytes > in.remaining()) {
      throw new PlayerException(
          "the message ends at byte " + in.limit() + ", where " + bytes + " bytes were expected from byte "
              + in.position());
    }
  }
}
