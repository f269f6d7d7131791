package org.robotui.player.client;

/** What became of a subscription to a device. */
public sealed interface DeviceState {

  /** Nobody subscribes to it. */
  record Unused() implements DeviceState {}

  /** The server is not reached, or did not answer yet. */
  record Waiting() implements DeviceState {}

  /**
   * The device is open: data come, commands go.
   *
   * @param driver the name of its driver
   */
  record Open(String driver) implements DeviceState {}

  /**
   * The server does not open it. It is tried again when the link is made anew.
   *
   * @param reason names device, server and cause, for a user to read
   */
  record Refused(String reason) implements DeviceState {}
}
