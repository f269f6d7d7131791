package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Locator;

/** Reads the values of parameters, from the position of a buffer in its byte order. */
public final class ParameterValue {

  private ParameterValue() {}

  /** Four bytes as a number. */
  public static int number(ByteBuffer in) throws WireException {
    WireInput.need(in, 4, "a number");
    return in.getInt();
  }

  /** Two bytes as a number without a sign. */
  public static int small(ByteBuffer in) throws WireException {
    WireInput.need(in, 2, "a number");
    return Short.toUnsignedInt(in.getShort());
  }

  /** Two bytes without a byte order. */
  public static int pair(ByteBuffer in) throws WireException {
    WireInput.need(in, 2, "two bytes");
    int first = Byte.toUnsignedInt(in.get());
    return first << 8 | Byte.toUnsignedInt(in.get());
  }

  /** Whether. */
  public static boolean flag(ByteBuffer in) throws WireException {
    WireInput.need(in, 1, "a truth value");
    return in.get() != 0;
  }

  /** How long. */
  public static Duration duration(ByteBuffer in) throws WireException {
    WireInput.need(in, 8, "a duration");
    return WireTime.duration(in.getInt(), in.getInt());
  }

  /** Which entity. */
  public static Guid guid(ByteBuffer in) throws WireException {
    return WireInput.guid(in);
  }

  /** Where. */
  public static Locator locator(ByteBuffer in) throws WireException {
    return WireInput.locator(in);
  }

  /**
   * A text. Bytes that are no UTF-8 become U+FFFD.
   *
   * @param most bytes that it may have, without its end
   */
  public static String text(ByteBuffer in, int most) throws WireException {
    ByteBuffer bytes = octets(in, most + 1);
    int end = bytes.remaining();
    if (end > 0 && bytes.get(end - 1) == 0) {
      end--;
    } else if (end > most) {
      throw new WireException("a text of " + end + " bytes");
    }
    return StandardCharsets.UTF_8.decode(bytes.limit(end)).toString();
  }

  /**
   * Bytes with their length before them.
   *
   * @param most how many they may be
   * @return a view
   */
  public static ByteBuffer octets(ByteBuffer in, int most) throws WireException {
    long length = WireInput.unsigned(in);
    if (length > most || length > in.remaining()) {
      throw new WireException("%d bytes, of at most %d; here are %d".formatted(length, most, in.remaining()));
    }
    ByteBuffer bytes = in.slice(in.position(), (int) length);
    in.position(in.position() + (int) length);
    return bytes;
  }

  /**
   * Texts, each aligned to four bytes.
   *
   * @param most how many they may be, and how many bytes each may have
   */
  public static List<String> texts(ByteBuffer in, int most) throws WireException {
    List<String> texts = new ArrayList<>();
    for (long count = counted(in, most); count > 0; count--) {
      in.position(Math.min(in.limit(), in.position() + 3 & ~3));
      texts.add(text(in, most));
    }
    return texts;
  }

  /**
   * Numbers of two bytes.
   *
   * @param most how many they may be
   */
  public static List<Integer> smallNumbers(ByteBuffer in, int most) throws WireException {
    List<Integer> numbers = new ArrayList<>();
    for (long count = counted(in, most); count > 0; count--) {
      numbers.add(small(in));
    }
    return numbers;
  }

  private static long counted(ByteBuffer in, int most) throws WireException {
    long count = WireInput.unsigned(in);
    if (count > most) {
      throw new WireException("a list of %d, of at most %d".formatted(count, most));
    }
    return count;
  }
}
