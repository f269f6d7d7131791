package org.robotui.rtps;

/**
 * Which version of RTPS a participant speaks.
 *
 * @param major 2 for all that are in use
 * @param minor what it knows beyond that; the rest is skipped
 */
public record ProtocolVersion(int major, int minor) {

  /** What this library speaks. */
  public static final ProtocolVersion V2_3 = new ProtocolVersion(2, 3);

  @Override
  public String toString() {
    return major + "." + minor;
  }
}
