package org.robotui.ros2;

import java.util.List;
import java.util.Set;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Qos;

/** Receives the messages of one topic from all its publishers. Any thread may use it. */
public interface Ros2Subscriber extends AutoCloseable {

  /**
   * Messages that came and could not be read.
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
   * @return its whole name
   */
  Ros2Name topic();

  /**
   * What is requested now; an adapting subscriber requests no more than what is offered.
   *
   * @return the quality of service
   */
  Qos qos();

  /**
   * How many publishers are heard.
   *
   * @return the number of matched writers
   */
  int numPublishers();

  /**
   * Who is heard.
   *
   * @return the nodes whose publishers match, as far as they are known by name
   */
  Set<Ros2Name> publishers();

  /**
   * Why publishers of the topic are not heard.
   *
   * @return a sentence for each, for a user to read
   */
  List<String> mismatches();

  /**
   * How many messages came in.
   *
   * @return the number of messages that were decoded, over all publishers so far
   */
  long received();

  /**
   * How many messages never came.
   *
   * @return by the numbers that publishers give them
   */
  long lost();

  /**
   * What came in and was of no use.
   *
   * @return the messages that could not be read
   */
  Unreadable unreadable();

  /**
   * How often the listener threw.
   *
   * @return the number of messages whose listener call ended with an exception
   */
  long listenerErrors();

  /** Takes it back from the network. A running listener call may still end after it. */
  @Override
  void close();
}
