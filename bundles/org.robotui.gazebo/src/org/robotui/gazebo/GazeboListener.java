package org.robotui.gazebo;

/** Hears what happens around a node, on its threads. Calls must not block. */
public interface GazeboListener {

  /**
   * Something came that nobody can read, and it was ignored.
   *
   * @param reason says from whom, for users
   */
  void onUnreadable(String reason);

  /** Something else is published, served or subscribed to than before, or another process is there or has gone. */
  default void onGraph() {}
}
