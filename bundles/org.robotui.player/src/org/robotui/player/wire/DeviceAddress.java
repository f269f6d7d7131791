package org.robotui.player.wire;

/**
 * Which device a message is from or for.
 *
 * @param host the server's IPv4 address as the server itself writes it: its first byte is the lowest
 * @param robot the robot, which is the server's TCP port
 * @param interfaceCode the code of the device's interface, 0 to 65535
 * @param index the device's number among those of its interface, 0 to 65535
 */
public record DeviceAddress(int host, int robot, int interfaceCode, int index) {

  /** The code of the interface {@code player}, which is the server itself. */
  public static final int SERVER = 1;

  private static final int MOST = 0xffff;

  /** Checks the ranges. */
  public DeviceAddress {
    if (interfaceCode < 0 || interfaceCode > MOST || index < 0 || index > MOST) {
      throw new IllegalArgumentException("interface " + interfaceCode + " index " + index + " is no device address");
    }
  }

  /**
   * The host as people write it.
   *
   * @return four numbers with dots
   */
  public String hostText() {
    return (host & 0xff) + "." + (host >> 8 & 0xff) + "." + (host >> 16 & 0xff) + "." + (host >>> 24);
  }

  /**
   * Which device of its server it is.
   *
   * @return interface and index
   */
  public DeviceId id() {
    return new DeviceId(interfaceCode, index);
  }

  /**
   * An address as the server writes it.
   *
   * @param address four or more bytes; of others than IPv4 the last four are taken
   * @return the number, first byte lowest
   */
  public static int host(byte[] address) {
    int at = address.length - Integer.BYTES;
    return address[at] & 0xff | (address[at + 1] & 0xff) << 8 | (address[at + 2] & 0xff) << 16 | address[at + 3] << 24;
  }

  @Override
  public String toString() {
    return interfaceCode + ":" + index + " of robot " + robot;
  }
}
