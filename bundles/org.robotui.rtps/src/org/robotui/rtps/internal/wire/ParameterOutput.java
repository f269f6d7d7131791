package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Locator;

/** Writes a parameter list. */
public final class ParameterOutput {

  private static final int SENTINEL = 0x0001;

  private static final int LONGEST = 0xfffc;

  private ByteBuffer out;

  /**
   * Begins an empty list.
   *
   * @param order its byte order
   */
  public ParameterOutput(ByteOrder order) {
    out = ByteBuffer.allocate(512).order(order);
  }

  /** Writes a parameter of at most so many bytes, and its length when that is known. */
  private ParameterOutput parameter(int id, int most, Consumer<ByteBuffer> value) {
    if (most > LONGEST) {
      throw new IllegalArgumentException("parameter 0x%04x has %d bytes".formatted(id, most));
    }
    room(most + 8);
    out.putShort((short) id).putShort((short) 0);
    int start = out.position();
    value.accept(out);
    WireOutput.align(out, start);
    out.putShort(start - 2, (short) (out.position() - start));
    return this;
  }

  private void room(int bytes) {
    if (out.remaining() < bytes) {
      ByteBuffer larger = ByteBuffer.allocate(2 * out.capacity() + bytes).order(out.order());
      out = larger.put(out.flip());
    }
  }

  /** Four bytes as a number. */
  public ParameterOutput number(int id, int value) {
    return parameter(id, 4, buffer -> buffer.putInt(value));
  }

  /** Several numbers of four bytes. */
  public ParameterOutput numbers(int id, int... values) {
    return parameter(id, 4 * values.length, buffer -> {
      for (int value : values) {
        buffer.putInt(value);
      }
    });
  }

  /** A number and a time. */
  public ParameterOutput numberAndDuration(int id, int value, Duration time) {
    return parameter(id, 12, buffer -> {
      buffer.putInt(value);
      put(buffer, time);
    });
  }

  /** Two bytes without a byte order. */
  public ParameterOutput pair(int id, int value) {
    return parameter(id, 2, buffer -> WireOutput.pair(buffer, value));
  }

  /** Whether. */
  public ParameterOutput flag(int id, boolean value) {
    return parameter(id, 1, buffer -> buffer.put((byte) (value ? 1 : 0)));
  }

  /** How long. */
  public ParameterOutput duration(int id, Duration time) {
    return parameter(id, 8, buffer -> put(buffer, time));
  }

  private static void put(ByteBuffer buffer, Duration time) {
    buffer.putInt(WireTime.seconds(time)).putInt(WireTime.fraction(time));
  }

  /** Which entity. */
  public ParameterOutput guid(int id, Guid guid) {
    return parameter(id, Guid.BYTES, buffer -> WireOutput.guid(buffer, guid));
  }

  /** Which sample. */
  public ParameterOutput sample(int id, Guid writer, long sequence) {
    return parameter(id, Guid.BYTES + 8, buffer -> {
      WireOutput.guid(buffer, writer);
      WireOutput.sequence(buffer, sequence);
    });
  }

  /** Where, one parameter for each. */
  public ParameterOutput locators(int id, List<Locator> locators) {
    locators.forEach(locator -> parameter(id, 24, buffer -> WireOutput.locator(buffer, locator)));
    return this;
  }

  /** A text. */
  public ParameterOutput text(int id, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    return parameter(id, bytes.length + 8, buffer -> put(buffer, bytes));
  }

  private static void put(ByteBuffer buffer, byte[] text) {
    buffer.putInt(text.length + 1).put(text).put((byte) 0);
  }

  /** Texts, each aligned to four bytes. */
  public ParameterOutput texts(int id, List<String> texts) {
    List<byte[]> all = texts.stream().map(text -> text.getBytes(StandardCharsets.UTF_8)).toList();
    return parameter(id, 4 + all.stream().mapToInt(bytes -> bytes.length + 8).sum(), buffer -> {
      int start = buffer.position();
      buffer.putInt(all.size());
      for (byte[] bytes : all) {
        WireOutput.align(buffer, start);
        put(buffer, bytes);
      }
    });
  }

  /** Bytes with their length before them. */
  public ParameterOutput octets(int id, ByteBuffer bytes) {
    return parameter(id, bytes.remaining() + 8, buffer -> buffer.putInt(bytes.remaining()).put(bytes.duplicate()));
  }

  /** Bytes alone. */
  public ParameterOutput plain(int id, byte[] bytes) {
    return parameter(id, bytes.length, buffer -> buffer.put(bytes));
  }

  /** Numbers of two bytes. */
  public ParameterOutput smallNumbers(int id, List<Integer> numbers) {
    return parameter(id, 4 + 2 * numbers.size(), buffer -> {
      buffer.putInt(numbers.size());
      numbers.forEach(number -> buffer.putShort(number.shortValue()));
    });
  }

  /**
   * Ends the list.
   *
   * @return its bytes with its end, in its byte order
   */
  public ByteBuffer finish() {
    room(4);
    out.putShort((short) SENTINEL).putShort((short) 0);
    ByteOrder order = out.order();
    return out.flip().slice().order(order);
  }
}
