package org.robotui.yarp.bottle;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Bottles as bytes, little endian. What a peer says of lengths is believed only as far as its bytes come. */
public final class BottleCodec {

  /** The most values of a bottle, those within lists counted, that are taken. */
  public static final int MOST_VALUES = 1 << 21;
  /** The most bytes of all texts and blobs of a bottle that are taken. */
  public static final int LONGEST = 1 << 26;
  private static final int DEEPEST = 64;

  private BottleCodec() {}

  /**
   * Reads a bottle from all bytes of a message.
   *
   * @param bytes of one message
   * @return what it holds
   * @throws YarpFormatException where the bytes are no bottle, or more than one
   */
  public static Bottle read(byte[] bytes) throws YarpFormatException {
    ByteArrayInputStream in = new ByteArrayInputStream(bytes);
    try {
      Bottle bottle = read(in);
      if (in.available() > 0) {
        throw new YarpFormatException(in.available() + " bytes follow a bottle that has ended");
      }
      return bottle;
    } catch (YarpFormatException e) {
      throw e;
    } catch (IOException e) {
      throw new YarpFormatException("a bottle ends within a value");
    }
  }

  /**
   * Reads the next bottle; blocks until all of it is there. It has no length before it, as replies have none.
   *
   * @param in of a connection
   * @return what it holds
   * @throws EOFException where the stream ends within it
   * @throws YarpFormatException where the bytes are no bottle
   * @throws IOException where the connection breaks
   */
  public static Bottle read(InputStream in) throws IOException {
    Reading reading = new Reading(in);
    return read(reading, reading.int32());
  }

  /**
   * Reads a bottle whose first number was read already.
   *
   * @param first that number
   * @param in what follows
   * @return what it holds
   * @throws IOException as {@link #read(InputStream)}
   */
  public static Bottle read(int first, InputStream in) throws IOException {
    return read(new Reading(in), first);
  }

  private static Bottle read(Reading reading, int tag) throws IOException {
    if (tag < BottleTag.LIST || tag >= 2 * BottleTag.LIST) {
      throw new YarpFormatException("a bottle begins with " + tag + ", which is no list");
    }
    return reading.list(tag - BottleTag.LIST, 0);
  }

  /**
   * Writes a bottle.
   *
   * @param bottle to be sent
   * @return its bytes
   */
  public static byte[] bytes(Bottle bottle) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    int32(out, BottleTag.of(bottle));
    write(out, bottle);
    return out.toByteArray();
  }

  private static void write(ByteArrayOutputStream out, Bottle bottle) {
    int32(out, bottle.size());
    for (YarpValue value : bottle.values()) {
      if (bottle.element() == 0) {
        int32(out, BottleTag.of(value));
      }
      switch (value) {
        case YarpValue.Whole whole -> number(out, whole.value(), whole.bits());
        case YarpValue.Real real -> number(out, bits(real), real.bits());
        case YarpValue.Vocab vocab -> int32(out, vocab.code());
        case YarpValue.Text text -> octets(out, text.value().getBytes(StandardCharsets.UTF_8));
        case YarpValue.Blob blob -> octets(out, blob.bytes());
        case Bottle list -> write(out, list);
      }
    }
  }

  private static long bits(YarpValue.Real real) {
    return real.bits() == Float.SIZE ? Float.floatToRawIntBits((float) real.value())
        : Double.doubleToRawLongBits(real.value());
  }

  private static void octets(ByteArrayOutputStream out, byte[] bytes) {
    int32(out, bytes.length);
    out.writeBytes(bytes);
  }

  private static void int32(ByteArrayOutputStream out, int value) {
    number(out, value, Integer.SIZE);
  }

  private static void number(ByteArrayOutputStream out, long value, int bits) {
    for (int shift = 0; shift < bits; shift += Byte.SIZE) {
      out.write((int) (value >>> shift));
    }
  }

  /** Counts what was read, so that lists within lists do not multiply. */
  private static final class Reading {
    private final InputStream in;
    private int left = MOST_VALUES;
    private int leftBytes = LONGEST;

    Reading(InputStream in) {
      this.in = in;
    }

    Bottle list(int element, int depth) throws IOException {
      if (depth > DEEPEST) {
        throw new YarpFormatException("lists are more than " + DEEPEST + " deep");
      }
      int count = int32();
      if (count < 0 || count > left) {
        throw new YarpFormatException("a list of " + count + " values; at most " + MOST_VALUES + " are taken");
      }
      left -= count;
      if (element == BottleTag.FLOAT32 || element == BottleTag.FLOAT64) {
        int bits = element == BottleTag.FLOAT32 ? Float.SIZE : Double.SIZE;
        return new Bottle(RealList.read(exactly(count * (bits / Byte.SIZE)), bits), element);
      }
      List<YarpValue> values = new ArrayList<>(Math.min(count, BottleTag.LIST));
      for (int i = 0; i < count; i++) {
        values.add(value(element == 0 ? int32() : element, depth));
      }
      return new Bottle(values, element);
    }

    private YarpValue value(int tag, int depth) throws IOException {
      return switch (tag) {
        case BottleTag.INT8 -> new YarpValue.Whole(exactly(Byte.BYTES).get(), Byte.SIZE);
        case BottleTag.INT16 -> new YarpValue.Whole(exactly(Short.BYTES).getShort(), Short.SIZE);
        case BottleTag.INT32 -> new YarpValue.Whole(int32(), Integer.SIZE);
        case BottleTag.INT64 -> new YarpValue.Whole(exactly(Long.BYTES).getLong(), Long.SIZE);
        case BottleTag.FLOAT32 -> new YarpValue.Real(exactly(Float.BYTES).getFloat(), Float.SIZE);
        case BottleTag.FLOAT64 -> new YarpValue.Real(exactly(Double.BYTES).getDouble(), Double.SIZE);
        case BottleTag.VOCAB -> new YarpValue.Vocab(int32());
        case BottleTag.STRING -> new YarpValue.Text(new String(octets(), StandardCharsets.UTF_8));
        case BottleTag.BLOB -> YarpValue.Blob.wrap(octets());
        default -> nested(tag, depth);
      };
    }

    private Bottle nested(int tag, int depth) throws IOException {
      if (tag < BottleTag.LIST || tag >= 2 * BottleTag.LIST) {
        throw new YarpFormatException("a value has the type " + tag
            + (tag >= 2 * BottleTag.LIST ? ", a dictionary, which is not read" : ", which bottles do not have"));
      }
      return list(tag - BottleTag.LIST, depth + 1);
    }

    private byte[] octets() throws IOException {
      int length = int32();
      if (length < 0 || length > leftBytes) {
        throw new YarpFormatException("a text or blob of " + length + " bytes; at most " + LONGEST
            + " are taken of a bottle");
      }
      leftBytes -= length;
      return exactly(length).array();
    }

    int int32() throws IOException {
      return exactly(Integer.BYTES).getInt();
    }

    /** What is not there yet is not allocated: a stream gives its bytes in pieces. */
    private ByteBuffer exactly(int length) throws IOException {
      byte[] bytes = in.readNBytes(length);
      if (bytes.length < length) {
        throw new EOFException("the connection ended");
      }
      return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }
  }
}
