package org.robotui.yarp.bottle;

import java.util.Arrays;
import java.util.List;

/** What a bottle of YARP can hold. Immutable. */
public sealed interface YarpValue
    permits YarpValue.Whole, YarpValue.Real, YarpValue.Text, YarpValue.Vocab, YarpValue.Blob, Bottle {

  /**
   * A whole number.
   *
   * @param value signed
   * @param bits 8, 16, 32 or 64
   */
  record Whole(long value, int bits) implements YarpValue {
    /** Refuses other widths with an {@link IllegalArgumentException}. */
    public Whole {
      BottleTag.whole(bits);
    }
  }

  /**
   * A number with a fraction.
   *
   * @param value any, also one that is not a number
   * @param bits 32 or 64
   */
  record Real(double value, int bits) implements YarpValue {
    /** Refuses other widths with an {@link IllegalArgumentException}. */
    public Real {
      BottleTag.real(bits);
    }
  }

  /**
   * A text.
   *
   * @param value of any length
   */
  record Text(String value) implements YarpValue {}

  /**
   * A short word that is sent as a number.
   *
   * @param code up to four characters, the first in the lowest byte
   */
  record Vocab(int code) implements YarpValue {
    private static final int BYTE = 8;
    private static final int MASK = 0xff;

    /**
     * The word.
     *
     * @return up to four characters
     */
    public String word() {
      StringBuilder word = new StringBuilder();
      for (int rest = code; rest != 0; rest >>>= BYTE) {
        word.append((char) (rest & MASK));
      }
      return word.toString();
    }

    /**
     * A word as a number.
     *
     * @param word up to four characters of one byte
     * @return its vocabulary
     */
    public static Vocab of(String word) {
      if (word.length() > Integer.BYTES) {
        throw new IllegalArgumentException("'" + word + "' is too long for a vocabulary, which has four characters");
      }
      int code = 0;
      for (int i = word.length() - 1; i >= 0; i--) {
        code = code << BYTE | word.charAt(i) & MASK;
      }
      return new Vocab(code);
    }
  }

  /** Bytes that YARP does not look into. Its array is never changed. */
  final class Blob implements YarpValue {
    private final byte[] bytes;

    private Blob(byte[] bytes) {
      this.bytes = bytes;
    }

    /**
     * Of an array that nobody changes any more.
     *
     * @param bytes is not copied
     * @return with these bytes
     */
    public static Blob wrap(byte[] bytes) {
      return new Blob(bytes);
    }

    /**
     * The bytes themselves.
     *
     * @return not to be changed
     */
    public byte[] bytes() {
      return bytes;
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Blob blob && Arrays.equals(bytes, blob.bytes);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(bytes);
    }

    @Override
    public String toString() {
      return bytes.length + " bytes";
    }
  }

  /**
   * The text of a text or a vocabulary, which YARP's programs use for each other.
   *
   * @return empty for all else
   */
  default String text() {
    return switch (this) {
      case Text text -> text.value();
      case Vocab vocab -> vocab.word();
      default -> "";
    };
  }

  /**
   * The number of a number.
   *
   * @return not a number for all else
   */
  default double number() {
    return switch (this) {
      case Whole whole -> whole.value();
      case Real real -> real.value();
      default -> Double.NaN;
    };
  }

  /**
   * The list that it is.
   *
   * @return an empty one for all else
   */
  default Bottle items() {
    return this instanceof Bottle bottle ? bottle : new Bottle(List.of(), 0);
  }
}
