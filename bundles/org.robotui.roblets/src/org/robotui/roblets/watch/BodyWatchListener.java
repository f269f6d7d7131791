package org.robotui.roblets.watch;

import org.robotui.roblets.body.BodyEntry;
import org.robotui.roblets.wire.RobletStatus;

/** Hears of a body. All is called on the thread of the watcher, and must not block. */
public interface BodyWatchListener {
  /**
   * The brain has answered.
   *
   * @param robot the name of the robot
   */
  default void welcomed(String robot) {}

  /**
   * How a roblet is now; said of each of them twice a second.
   *
   * @param status how it is
   */
  default void roster(RobletStatus status) {}

  /**
   * A roblet that is wanted has said something.
   *
   * @param roblet its name
   * @param entry what it said
   * @param bytes the datagram as it came
   */
  default void said(String roblet, BodyEntry entry, byte[] bytes) {}

  /**
   * Something came that cannot be read.
   *
   * @param reason a sentence for users
   */
  default void unreadable(String reason) {}
}
