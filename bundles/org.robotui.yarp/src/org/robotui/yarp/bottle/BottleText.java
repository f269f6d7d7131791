package org.robotui.yarp.bottle;

import java.util.ArrayList;
import java.util.List;

/**
 * Bottles as people and the text carrier write them: values with spaces between, lists in {@code ( )}, vocabularies in
 * {@code [ ]}, blobs as numbers in braces, texts in quotes where they could be taken for something else.
 */
public final class BottleText {
  private static final int MASK = 0xff;

  private BottleText() {}

  /**
   * Writes a bottle.
   *
   * @param bottle to be read by people
   * @return one line, without its end
   */
  public static String format(Bottle bottle) {
    StringBuilder out = new StringBuilder();
    for (YarpValue value : bottle.values()) {
      out.append(out.isEmpty() ? "" : " ").append(word(value));
    }
    return out.toString();
  }

  private static String word(YarpValue value) {
    return switch (value) {
      case YarpValue.Whole whole -> Long.toString(whole.value());
      case YarpValue.Real real -> real(real.value());
      case YarpValue.Vocab vocab -> vocab.code() == 0 ? "false"
          : vocab.word().equals("1") ? "true"
              : "[" + vocab.word() + "]";
      case YarpValue.Text text -> quoted(text.value());
      case YarpValue.Blob blob -> blob(blob.bytes());
      case Bottle list -> "(" + format(list) + ")";
    };
  }

  private static String real(double value) {
    if (Double.isNaN(value)) {
      return "nan";
    }
    return Double.isInfinite(value) ? value > 0 ? "inf" : "-inf" : Double.toString(value);
  }

  private static String blob(byte[] bytes) {
    StringBuilder out = new StringBuilder("{");
    for (byte each : bytes) {
      out.append(out.length() > 1 ? " " : "").append(each & MASK);
    }
    return out.append('}').toString();
  }

  private static String quoted(String text) {
    boolean plain = !text.isEmpty() && Character.isLetter(text.charAt(0)) && !text.equals("true")
        && !text.equals("false") && !text.equals("nan") && !text.equals("inf") && !text.equals("null")
        && text.chars().noneMatch(c -> c <= ' ' || "\"()[]{},\\".indexOf(c) >= 0);
    if (plain) {
      return text;
    }
    StringBuilder out = new StringBuilder("\"");
    for (char each : text.toCharArray()) {
      switch (each) {
        case '\n' -> out.append("\\n");
        case '\r' -> out.append("\\r");
        case '"', '\\' -> out.append('\\').append(each);
        default -> out.append(each);
      }
    }
    return out.append('"').toString();
  }

  /**
   * Reads what people write.
   *
   * @param text one bottle
   * @return the values
   * @throws YarpFormatException where brackets or quotes do not match
   */
  public static Bottle parse(String text) throws YarpFormatException {
    Scan scan = new Scan(text);
    Bottle bottle = scan.list((char) 0, 0);
    return bottle;
  }

  /** Goes through a text once. */
  private static final class Scan {
    private static final int DEEPEST = 64;

    private final String text;
    private int at;

    Scan(String text) {
      this.text = text;
    }

    Bottle list(char end, int depth) throws YarpFormatException {
      if (depth > DEEPEST) {
        throw new YarpFormatException("lists are more than " + DEEPEST + " deep");
      }
      List<YarpValue> values = new ArrayList<>();
      while (true) {
        while (at < text.length() && (text.charAt(at) <= ' ' || text.charAt(at) == ',')) {
          at++;
        }
        if (at >= text.length()) {
          if (end != 0) {
            throw new YarpFormatException("'" + end + "' is missing at the end");
          }
          return Bottle.of(values);
        }
        char next = text.charAt(at);
        if (next == end) {
          at++;
          return Bottle.of(values);
        }
        values.add(value(next, depth));
      }
    }

    private YarpValue value(char next, int depth) throws YarpFormatException {
      return switch (next) {
        case '(' -> {
          at++;
          yield list(')', depth + 1);
        }
        case '[' -> vocab();
        case '{' -> blob(depth);
        case '"' -> new YarpValue.Text(quoted());
        case ')', ']', '}' -> throw new YarpFormatException("'" + next + "' closes nothing");
        default -> word();
      };
    }

    private YarpValue vocab() throws YarpFormatException {
      int end = text.indexOf(']', at);
      if (end < 0) {
        throw new YarpFormatException("']' is missing at the end");
      }
      String word = text.substring(at + 1, end);
      at = end + 1;
      try {
        return YarpValue.Vocab.of(word);
      } catch (IllegalArgumentException e) {
        throw new YarpFormatException(e.getMessage());
      }
    }

    private YarpValue blob(int depth) throws YarpFormatException {
      at++;
      double[] numbers = list('}', depth + 1).numbers();
      byte[] bytes = new byte[numbers.length];
      for (int i = 0; i < bytes.length; i++) {
        bytes[i] = (byte) numbers[i];
      }
      return YarpValue.Blob.wrap(bytes);
    }

    private String quoted() throws YarpFormatException {
      StringBuilder out = new StringBuilder();
      for (at++; at < text.length() && text.charAt(at) != '"'; at++) {
        char each = text.charAt(at);
        if (each == '\\' && at + 1 < text.length()) {
          char escaped = text.charAt(++at);
          out.append(escaped == 'n' ? '\n' : escaped == 'r' ? '\r' : escaped);
        } else {
          out.append(each);
        }
      }
      if (at >= text.length()) {
        throw new YarpFormatException("a quote is missing at the end");
      }
      at++;
      return out.toString();
    }

    private YarpValue word() {
      int begin = at;
      while (at < text.length() && text.charAt(at) > ' ' && "()[]{},\"".indexOf(text.charAt(at)) < 0) {
        at++;
      }
      String word = text.substring(begin, at);
      return switch (word) {
        case "true" -> YarpValue.Vocab.of("1");
        case "false" -> new YarpValue.Vocab(0);
        case "inf", "-inf", "nan" -> new YarpValue.Real(special(word), Double.SIZE);
        default -> number(word);
      };
    }

    private static double special(String word) {
      return word.equals("nan") ? Double.NaN
          : word.equals("inf") ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
    }

    private static YarpValue number(String word) {
      boolean digits = word.matches("[-+]?[0-9]+");
      try {
        if (digits) {
          long value = Long.parseLong(word);
          return new YarpValue.Whole(value, value == (int) value ? Integer.SIZE : Long.SIZE);
        }
        return word.matches("[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?")
            ? new YarpValue.Real(Double.parseDouble(word), Double.SIZE)
            : new YarpValue.Text(word);
      } catch (NumberFormatException e) {
        return new YarpValue.Text(word);
      }
    }
  }
}
