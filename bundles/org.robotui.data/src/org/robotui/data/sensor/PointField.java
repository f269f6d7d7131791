package org.robotui.data.sensor;

import org.robotui.data.internal.Check;

/**
 * A field of the points of a cloud.
 *
 * @param name for example x, y, z, intensity, rgb, ring
 * @param offset of its first byte within a point
 * @param format its number format
 * @param count how many numbers it holds
 */
public record PointField(String name, int offset, Format format, int count) {
  /** Number formats. */
  public enum Format {
    /** Signed, 8 bits. */
    INT8(1),
    /** Unsigned, 8 bits. */
    UINT8(1),
    /** Signed, 16 bits. */
    INT16(2),
    /** Unsigned, 16 bits. */
    UINT16(2),
    /** Signed, 32 bits. */
    INT32(4),
    /** Unsigned, 32 bits. */
    UINT32(4),
    /** IEEE 754, 32 bits. */
    FLOAT32(4),
    /** IEEE 754, 64 bits. */
    FLOAT64(8);

    private final int size;

    Format(int size) {
      this.size = size;
    }

    /**
     * Bytes a number.
     *
     * @return 1, 2, 4 or 8
     */
    public int size() {
      return size;
    }
  }

  /**
   * Checks offset and count.
   *
   * @param name the name
   * @param offset bytes
   * @param format the number format
   * @param count how many
   */
  public PointField {
    Check.notNegative(offset, "offset");
    Check.that(count > 0, "count", "must be positive, is " + count);
  }
}
