package org.robotui.ros.master;

import java.io.IOException;
import java.net.URI;
import org.robotui.ros.internal.master.MasterRuntime;

/** A running ROS master with its parameter server. */
public interface RosMaster extends AutoCloseable {

  /**
   * Starts a master.
   *
   * @param options what the owner gives it
   * @return the running master
   * @throws IOException if it cannot listen where it should
   */
  static RosMaster open(MasterOptions options) throws IOException {
    return MasterRuntime.open(options);
  }

  /**
   * The address for ROS_MASTER_URI.
   *
   * @return an {@code http} URI
   */
  URI uri();

  /** Ends the master in less than two seconds. Nodes stay as they are, as with every ROS master. */
  @Override
  void close();
}
