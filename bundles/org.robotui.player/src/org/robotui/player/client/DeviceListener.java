package org.robotui.player.client;

import org.robotui.player.wire.PlayerMessage;

/** Hears of one device. All calls come from the receiving thread, one after another, and must not block. */
@FunctionalInterface
public interface DeviceListener {

  /**
   * Data came.
   *
   * @param message as it is on the wire, its stamp in seconds of the server's clock
   * @param receiveNanos when its last byte was read, by {@link System#nanoTime()}
   */
  void onData(PlayerMessage message, long receiveNanos);

  /**
   * The state of the device changed.
   *
   * @param state the new state
   */
  default void onState(DeviceState state) {}
}
