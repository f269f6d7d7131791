package org.robotui.ros;

import java.util.Set;

/** Receives the messages of one topic from all its publishers. Any thread may use it. */
public interface Subscriber extends AutoCloseable {
  /**
   * Messages that came and could not be read, or are of another type, which another subscriber of the node wants. Each
   * that no subscriber could read ended the link that it came by, which is made again.
   *
   * @param count over all publishers so far
   * @param reason why the last of them could not be read, and whose it was; empty where there is none
   */
  record Unreadable(long count, String reason) {
    /** None so far. */
    public static final Unreadable NONE = new Unreadable(0, "");
  }

  /**
   * The topic.
   *
   * @return its global name
   */
  GraphName topic();

  /**
   * How many publishers are connected.
   *
   * @return the number of links that exchanged their headers, to publishers of the type that is wanted
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
   * What came in and was of no use.
   *
   * @return the messages that could not be read
   */
  Unreadable unreadable();

  /**
   * How often the message listener threw.
   *
   * @return the number of messages whose listener call ended with an exception
   */
  long listenerErrors();

  /**
   * Ends it. The last subscriber of the node to the topic unregisters from the master, in the background, and closes
   * all links. A running listener call may still end after it.
   */
  @Override
  void close();
}
