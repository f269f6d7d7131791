package org.robotui.ros;

/** A service this node offers. */
public interface ServiceServer extends AutoCloseable {

  /**
   * The service.
   *
   * @return its global name
   */
  GraphName name();

  /** Unregisters from the master, in the background, and closes the clients' connections. */
  @Override
  void close();
}
