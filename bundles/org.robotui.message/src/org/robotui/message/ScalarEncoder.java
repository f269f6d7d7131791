package org.robotui.message;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;

/** Writes single values of built-in types from Java values, checking their range. */
final class ScalarEncoder {

  private final MessageWriter out;

  ScalarEncoder(MessageWriter out) {
    this.out = out;
  }

  /** Writes one value within the bound of its field. */
  void write(Layout.Field field, Object value) throws MessageException {
    int most = field.type().textBound();
    write(field.primitive(), most == 0 ? value : LengthBounds.text(text(value), most, ""));
  }

  /** Writes one value; null is zero or empty. */
  void write(Primitive type, Object value) throws MessageException {
    switch (type) {
      case BOOL -> out.bool(flag(value));
      case INT8, BYTE -> out.u8((int) signed(type, value, 8));
      case UINT8, CHAR -> out.u8((int) unsigned(type, value, 8));
      case INT16 -> out.i16((int) signed(type, value, 16));
      case UINT16 -> out.i16((int) unsigned(type, value, 16));
      case INT32 -> out.i32((int) signed(type, value, 32));
      case UINT32 -> out.i32((int) unsigned(type, value, 32));
      case INT64 -> out.i64(signed(type, value, 64));
      case UINT64 -> out.i64(unsigned(type, value, 64));
      case FLOAT32 -> out.f32((float) real(type, value));
      case FLOAT64 -> out.f64(real(type, value));
      case STRING, WSTRING -> out.string(text(value));
      case TIME, DURATION -> time(type, value);
    }
  }

  static String describe(Object value) {
    return switch (value) {
      case null -> "nothing";
      case String text -> "the text '" + text + "'";
      case Number number -> "the number " + number;
      case Boolean flag -> "'" + flag + "'";
      case DynamicMessage message -> message.type();
      default -> "a " + value.getClass().getSimpleName();
    };
  }

  private boolean flag(Object value) throws MessageException {
    return switch (value) {
      case null -> false;
      case Boolean flag -> flag;
      case Number number when number.doubleValue() == 0 || number.doubleValue() == 1 -> number.doubleValue() == 1;
      case String text when text.equalsIgnoreCase("true") || text.equalsIgnoreCase("false") -> text
          .equalsIgnoreCase("true");
      default -> throw mismatch(Primitive.BOOL, value);
    };
  }

  private long signed(Primitive type, Object value, int bits) throws MessageException {
    BigInteger number = integer(type, value);
    if (number.bitLength() >= bits) {
      throw mismatch(type, value);
    }
    return number.longValue();
  }

  private long unsigned(Primitive type, Object value, int bits) throws MessageException {
    BigInteger number = integer(type, value);
    if (number.signum() < 0 || number.bitLength() > bits) {
      throw mismatch(type, value);
    }
    return number.longValue();
  }

  private BigInteger integer(Primitive type, Object value) throws MessageException {
    try {
      return switch (value) {
        case null -> BigInteger.ZERO;
        case Boolean flag -> flag ? BigInteger.ONE : BigInteger.ZERO;
        case BigInteger number -> number;
        case Long number -> BigInteger.valueOf(number);
        case Integer number -> BigInteger.valueOf(number);
        case Short number -> BigInteger.valueOf(number);
        case Byte number -> BigInteger.valueOf(number);
        case Number number -> BigDecimal.valueOf(number.doubleValue()).toBigIntegerExact();
        case String text -> new BigInteger(text.strip());
        default -> throw mismatch(type, value);
      };
    } catch (ArithmeticException | NumberFormatException e) {
      throw mismatch(type, value);
    }
  }

  private double real(Primitive type, Object value) throws MessageException {
    try {
      return switch (value) {
        case null -> 0;
        case Number number -> number.doubleValue();
        case String text -> parse(text.strip());
        default -> throw mismatch(type, value);
      };
    } catch (NumberFormatException e) {
      throw mismatch(type, value);
    }
  }

  private static double parse(String text) {
    return switch (text.toLowerCase(Locale.ROOT)) {
      case "nan" -> Double.NaN;
      case "inf", "+inf", "infinity" -> Double.POSITIVE_INFINITY;
      case "-inf", "-infinity" -> Double.NEGATIVE_INFINITY;
      default -> Double.parseDouble(text);
    };
  }

  private String text(Object value) throws MessageException {
    return switch (value) {
      case null -> "";
      case CharSequence text -> text.toString();
      case Number number -> number.toString();
      case Boolean flag -> flag.toString();
      default -> throw mismatch(Primitive.STRING, value);
    };
  }

  private void time(Primitive type, Object value) throws MessageException {
    if (value instanceof Map<?, ?> parts) {
      Primitive part = type == Primitive.TIME ? Primitive.UINT32 : Primitive.INT32;
      write(part, first(parts, "sec", "secs"));
      write(part, first(parts, "nanosec", "nsecs", "nsec"));
      return;
    }
    long nanos = signed(Primitive.INT64, value, 64);
    long seconds = Math.floorDiv(nanos, 1_000_000_000L);
    boolean fits = type == Primitive.TIME ? seconds >>> 32 == 0 : seconds == (int) seconds;
    if (!fits) {
      throw mismatch(type, value);
    }
    Stamps.write(nanos, out);
  }

  private static Object first(Map<?, ?> parts, String... names) {
    return Stream.of(names).filter(parts::containsKey).findFirst().map(name -> (Object) parts.get(name)).orElse(null);
  }

  private MessageException mismatch(Primitive type, Object value) {
    return new MessageException(describe(value) + " is no " + type.rosName(), "", out.size());
  }
}
