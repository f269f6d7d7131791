package org.robotui.rtps;

import java.util.HexFormat;

/**
 * What all entities of one participant have in common: 12 bytes, of which the first two name the vendor.
 *
 * @param high the first eight bytes
 * @param low the last four bytes
 */
public record GuidPrefix(long high, int low) implements Comparable<GuidPrefix> {

  /** How many bytes it has. */
  public static final int BYTES = 12;

  /** No participant, or every one. */
  public static final GuidPrefix UNKNOWN = new GuidPrefix(0, 0);

  /**
   * Who made the participant's library.
   *
   * @return by its first two bytes
   */
  public VendorId vendor() {
    return new VendorId((int) (high >>> Long.SIZE - Short.SIZE));
  }

  @Override
  public int compareTo(GuidPrefix other) {
    int first = Long.compareUnsigned(high, other.high);
    return first != 0 ? first : Integer.compareUnsigned(low, other.low);
  }

  /** As ROS 2 and the tools of the vendors write it: bytes in hexadecimal digits, with dots between them. */
  @Override
  public String toString() {
    HexFormat hex = HexFormat.of();
    String digits = hex.toHexDigits(high) + hex.toHexDigits(low);
    return digits.replaceAll("(..)(?!$)", "$1.");
  }
}
