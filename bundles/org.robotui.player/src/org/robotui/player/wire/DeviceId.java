package org.robotui.player.wire;

/**
 * Which device of a server.
 *
 * @param interfaceCode the code of its interface
 * @param index its number among those of its interface
 */
public record DeviceId(int interfaceCode, int index) {

  /** The server itself. */
  public static final DeviceId SERVER = new DeviceId(DeviceAddress.SERVER, 0);

  /**
   * The address of the device at a server.
   *
   * @param host the server's address, first byte lowest
   * @param robot the server's port
   * @return the address
   */
  public DeviceAddress at(int host, int robot) {
    return new DeviceAddress(host, robot, interfaceCode, index);
  }
}
