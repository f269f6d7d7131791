package org.robotui.ros;

import java.util.Set;

/** Receives the messages of one topic from all its publishers. Any thread may use it. */
public interface Subscriber extends AutoCloseable {

  /**
   * The topic.
   *
   * @return its global name
   */
  GraphName topic();

  /**
   * How many publishers are connected.
   *
   * @return the number of links that exchanged their headers
   */
  int numPublishers();

  /**
   * Who is connected.
   *
   * @return the node names the publishers announced
   */
  Set<String> publishers();

  /**
   * How many messages came in.
   *
   * @return the number of messages that were decoded, over all publishers so far
   */
  long received();

  /**
   * How often the message listener threw.
   *
   * @return the number of messages whose listener call ended with an exception
   */
  long listenerErrors();

  /** Unregisters from the master, in the background, and closes all links. A running listener call may still end after it. */
  @Override
  void close();
}
