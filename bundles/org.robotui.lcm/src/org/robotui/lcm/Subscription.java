package org.robotui.lcm;

/** Receives the messages of some channels. Any thread may use it. */
public interface Subscription extends AutoCloseable {

  /**
   * Which channels.
   *
   * @return the regular expression that the whole name of a channel matches
   */
  String channels();

  /**
   * How many messages reached the listener.
   *
   * @return the number of calls
   */
  long received();

  /**
   * How many messages its full queue dropped.
   *
   * @return the number of messages
   */
  long dropped();

  /**
   * How often the listener threw.
   *
   * @return the number of calls
   */
  long listenerErrors();

  /** Ends it. A running listener call may still end after it. */
  @Override
  void close();
}
