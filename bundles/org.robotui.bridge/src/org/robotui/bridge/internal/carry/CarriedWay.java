package org.robotui.bridge.internal.carry;

import org.robotui.api.bridge.BridgeStatus;

/** One way of a bridge. Used by the thread of the bridges; its status may be asked for by any. */
interface CarriedWay extends AutoCloseable {
  /** How it is doing. */
  BridgeStatus status();

  /** Whether something waits for its time, so that it is worth looking again at once. */
  default boolean isWaiting() {
    return false;
  }

  /** Follows what has come and gone. */
  void look(long now);

  /** Takes what has come, and passes on what may pass. */
  default void carry(long now) {}

  @Override
  void close();
}
