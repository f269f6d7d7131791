package org.robotui.player.server;

import org.robotui.player.wire.PlayerMessage;

/**
 * What a device does. Calls come from the threads of the clients, also several at once; a slow one holds up its own
 * client only.
 */
public interface DeviceHandler {

  /**
   * A client commands.
   *
   * @param command the command, also from a client that has not opened the device
   */
  void onCommand(PlayerMessage command);

  /**
   * A client asks.
   *
   * @param request the request, from a client that opened the device
   * @return the answer
   */
  Answer onRequest(PlayerMessage request);

  /**
   * A client opened or closed the device, or went.
   *
   * @param clients how many have it open now
   */
  default void onClients(int clients) {}
}
