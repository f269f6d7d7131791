package org.robotui.ui.control;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.RoundingMode;
import java.time.Clock;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.robotui.api.input.TypedText;
import org.robotui.api.input.Unreadable;
import org.robotui.data.record.FieldShape;

/** Reads what was typed into a field. Blank is zero, as it is for the robot. Pure but for the clock. */
final class FormInput {
  private static final int NANO_DIGITS = 9;
  private static final long NANOS = 1_000_000_000L;
  private static final int MOST_NUMBERS = 1_000_000;
  private static final String NOW = "now";

  private final Clock clock;

  FormInput(Clock clock) {
    this.clock = clock;
  }

  /** Reads one value of a form that is neither a record nor many records. */
  Object read(FieldShape shape, String typed) throws Unreadable {
    String text = typed.isBlank() ? blank(shape) : typed.strip();
    return switch (shape) {
      case FieldShape.Flag f -> TypedText.flag(text);
      case FieldShape.Whole w -> whole(w, text);
      case FieldShape.Real r -> real(r, text);
      case FieldShape.Text t -> typed;
      case FieldShape.Time t -> time(text);
      case FieldShape.Duration d -> duration(text);
      case FieldShape.Many m -> many(m, text);
      case FieldShape.Nested n -> throw new Unreadable("is a record and cannot be typed in one line");
    };
  }

  private static String blank(FieldShape shape) {
    return shape instanceof FieldShape.Many ? "" : "0";
  }

  /** What stands in an empty field. */
  static String placeholder(FieldShape shape) {
    return switch (shape) {
      case FieldShape.Whole w -> "0";
      case FieldShape.Real r -> "0.0";
      case FieldShape.Time t -> "0 s, or now";
      case FieldShape.Duration d -> "0 s";
      case FieldShape.Many m when m.size() > 0 -> m.size() + " numbers, 0 each";
      case FieldShape.Many m -> "numbers, separated by commas";
      default -> "";
    };
  }

  private static Object whole(FieldShape.Whole shape, String text) throws Unreadable {
    BigInteger least = shape.signed() ? BigInteger.ONE.shiftLeft(shape.bits() - 1).negate() : BigInteger.ZERO;
    BigInteger most =
        BigInteger.ONE.shiftLeft(shape.signed() ? shape.bits() - 1 : shape.bits()).subtract(BigInteger.ONE);
    BigInteger value = TypedText.whole(text, least, most);
    return value.bitLength() < Long.SIZE ? (Object) value.longValueExact() : value;
  }

  private static Double real(FieldShape.Real shape, String text) throws Unreadable {
    double value = TypedText.real(text);
    if (shape.bits() == Float.SIZE && Double.isFinite(value) && Math.abs(value) > Float.MAX_VALUE) {
      throw new Unreadable("is too large for single precision");
    }
    return value;
  }

  private Long time(String text) throws Unreadable {
    if (text.equalsIgnoreCase(NOW)) {
      Instant now = clock.instant();
      return now.getEpochSecond() * NANOS + now.getNano();
    }
    long nanos = nanos(text, "is no time: write seconds, or now");
    if (nanos < 0 || nanos / NANOS >>> Integer.SIZE != 0) {
      throw new Unreadable("must be from 0 to 4294967295 seconds");
    }
    return nanos;
  }

  private static Long duration(String text) throws Unreadable {
    long nanos = nanos(text, "is no duration: write seconds");
    if (Math.floorDiv(nanos, NANOS) != (int) Math.floorDiv(nanos, NANOS)) {
      throw new Unreadable("must be from \u22122147483648 to 2147483647 seconds");
    }
    return nanos;
  }

  private static long nanos(String text, String otherwise) throws Unreadable {
    try {
      BigDecimal seconds = new BigDecimal(text.endsWith("s") ? text.substring(0, text.length() - 1).strip() : text);
      return seconds.setScale(NANO_DIGITS, RoundingMode.HALF_UP).unscaledValue().longValueExact();
    } catch (ArithmeticException | NumberFormatException e) {
      throw new Unreadable(otherwise);
    }
  }

  private List<Object> many(FieldShape.Many shape, String text) throws Unreadable {
    String bare = text.startsWith("[") && text.endsWith("]") ? text.substring(1, text.length() - 1).strip() : text;
    if (bare.isEmpty()) {
      return Collections.nCopies(shape.size(), read(shape.element(), ""));
    }
    String[] parts = bare.split("[\\s,;]+", MOST_NUMBERS);
    if (shape.size() > 0 && parts.length != shape.size()) {
      throw new Unreadable("needs " + shape.size() + " numbers, not " + parts.length);
    }
    List<Object> values = new ArrayList<>(parts.length);
    for (int i = 0; i < parts.length; i++) {
      values.add(element(shape.element(), parts[i], i));
    }
    return values;
  }

  private Object element(FieldShape shape, String part, int index) throws Unreadable {
    try {
      return read(shape, part);
    } catch (Unreadable e) {
      throw new Unreadable("[" + index + "] '" + part + "' " + e.getMessage());
    }
  }
}
