package org.robotui.rtps;

/**
 * Who made a participant's library.
 *
 * @param value the two bytes that the OMG gave to it, the first one highest
 */
public record VendorId(int value) {

  /** Fast DDS. */
  public static final VendorId FAST_DDS = new VendorId(0x010f);

  /** Cyclone DDS. */
  public static final VendorId CYCLONE_DDS = new VendorId(0x0110);

  /** Nobody: the OMG gave RobotUI no number, and this one is not given to anybody either. */
  public static final VendorId UNKNOWN = new VendorId(0);

  /** A name for a person to read. */
  @Override
  public String toString() {
    return switch (value) {
      case 0 -> "unknown vendor";
      case 0x0101 -> "RTI Connext";
      case 0x0102 -> "OpenSplice";
      case 0x0103 -> "OpenDDS";
      case 0x0106 -> "CoreDX";
      case 0x010f -> "Fast DDS";
      case 0x0110 -> "Cyclone DDS";
      case 0x0111 -> "GurumDDS";
      case 0x0112 -> "RustDDS";
      case 0x0114 -> "Zhenrong DDS";
      default -> "vendor 0x%04x".formatted(value);
    };
  }
}
