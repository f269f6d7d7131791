package org.robotui.web.tree;

import java.math.BigInteger;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads CBOR (RFC 8949) with typed arrays (RFC 8746), as bridges send it. Every length is compared with the bytes that
 * are left before anything is allocated. What has no definite length is refused: no bridge sends it.
 */
public final class Cbor {

  private static final int UNSIGNED = 0;
  private static final int NEGATIVE = 1;
  private static final int BYTES = 2;
  private static final int TEXT = 3;
  private static final int ARRAY = 4;
  private static final int MAP = 5;
  private static final int TAG = 6;

  private final ByteBuffer in;
  private final TreeBudget budget = new TreeBudget();

  private Cbor(ByteBuffer in) {
    this.in = in;
  }

  /**
   * Reads a whole value.
   *
   * @param bytes from position to limit, which are moved nowhere
   * @return the tree
   * @throws TreeException if it is none, or nested too deeply, or holds too much
   */
  public static Object read(ByteBuffer bytes) throws TreeException {
    Cbor reader = new Cbor(bytes.slice());
    try {
      Object tree = reader.value(0);
      if (reader.in.hasRemaining()) {
        throw new TreeException("something follows after the end");
      }
      return tree;
    } catch (BufferUnderflowException e) {
      throw new TreeException("no CBOR: it ends too early");
    }
  }

  private Object value(int depth) throws TreeException {
    TreeBudget.depth(depth);
    budget.value();
    int head = in.get() & 0xFF;
    int kind = head >> 5;
    int detail = head & 0x1F;
    if (kind == 7) {
      return simple(detail);
    }
    long number = number(detail);
    return switch (kind) {
      case UNSIGNED -> number >= 0 ? (Object) number : new BigInteger(Long.toUnsignedString(number));
      case NEGATIVE -> number >= 0 ? (Object) (-1 - number)
          : new BigInteger(Long.toUnsignedString(number)).not();
      case BYTES -> bytes(number);
      case TEXT -> new String(bytes(number), StandardCharsets.UTF_8);
      case ARRAY -> array(count(number, 1), depth);
      case MAP -> map(count(number, 2), depth);
      case TAG -> tagged(number, value(depth + 1));
      default -> throw new TreeException("no CBOR");
    };
  }

  private long number(int detail) throws TreeException {
    return switch (detail) {
      case 24 -> in.get() & 0xFFL;
      case 25 -> in.getShort() & 0xFFFFL;
      case 26 -> in.getInt() & 0xFFFF_FFFFL;
      case 27 -> in.getLong();
      default -> {
        if (detail > 27) {
          throw new TreeException("a value without a definite length is not read");
        }
        yield detail;
      }
    };
  }

  private Object simple(int detail) throws TreeException {
    return switch (detail) {
      case 20 -> false;
      case 21 -> true;
      case 22, 23 -> JsonNull.NULL;
      case 25 -> (double) Float.float16ToFloat(in.getShort());
      case 26 -> (double) in.getFloat();
      case 27 -> in.getDouble();
      default -> throw new TreeException("no CBOR: a simple value " + detail);
    };
  }

  private byte[] bytes(long length) throws TreeException {
    byte[] bytes = new byte[count(length, 1)];
    in.get(bytes);
    return bytes;
  }

  private int count(long length, int leastSize) throws TreeException {
    if (length < 0 || length > in.remaining() / leastSize) {
      throw new TreeException("a length of " + Long.toUnsignedString(length) + ", but " + in.remaining()
          + " bytes are left");
    }
    return (int) length;
  }

  private Object array(int count, int depth) throws TreeException {
    List<Object> items = new ArrayList<>(Math.min(count, 1000));
    boolean numbers = count > 0;
    for (int i = 0; i < count; i++) {
      Object item = value(depth + 1);
      numbers &= item instanceof Long || item instanceof Double;
      items.add(item);
    }
    return numbers ? packed(items) : items;
  }

  private static Object packed(List<Object> items) {
    NumberArray numbers = new NumberArray();
    for (Object each : items) {
      if (each instanceof Long whole) {
        numbers.add(whole);
      } else {
        numbers.add((double) (Double) each);
      }
    }
    return numbers.array();
  }

  private Map<String, Object> map(int count, int depth) throws TreeException {
    Map<String, Object> members = new LinkedHashMap<>();
    for (int i = 0; i < count; i++) {
      if (!(value(depth + 1) instanceof String name)) {
        throw new TreeException("a name that is no text");
      }
      members.put(name, value(depth + 1));
    }
    return members;
  }

  private static Object tagged(long tag, Object value) throws TreeException {
    return tag >= 64 && tag <= 87 && value instanceof byte[] bytes ? TypedArray.read((int) tag, bytes) : value;
  }
}
