package org.robotui.ros2;

import org.robotui.ros2.name.Ros2Name;

/** A service this node offers. */
public interface Ros2ServiceServer extends AutoCloseable {

  /**
   * The service.
   *
   * @return its whole name
   */
  Ros2Name name();

  /** Takes it back from the network; calls that wait are not answered. */
  @Override
  void close();
}
