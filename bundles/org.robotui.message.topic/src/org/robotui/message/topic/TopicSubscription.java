package org.robotui.message.topic;

/** Messages of a topic that come. Any thread may use it. */
public interface TopicSubscription extends AutoCloseable {

  /**
   * How many publishers are connected.
   *
   * @return the number of those from which messages can come now
   */
  int publishers();

  /**
   * Messages that were lost before anybody could look at them.
   *
   * @return how many since the subscription began, and why the last one was
   */
  Lost lost();

  /** Ends the subscription; a call of its listener may still end after it. */
  @Override
  void close();

  /**
   * Messages that were lost.
   *
   * @param count since the subscription began
   * @param reason why the last of them was lost, and whose it was; empty where there is none
   */
  record Lost(long count, String reason) {
    /** None so far. */
    public static final Lost NONE = new Lost(0, "");
  }
}
