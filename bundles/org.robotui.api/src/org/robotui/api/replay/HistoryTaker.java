package org.robotui.api.replay;

/** Is given what a recording holds. All on the thread that reads. */
public interface HistoryTaker {
  /**
   * A value.
   *
   * @param value the next one
   */
  void take(RecordedValue value);

  /**
   * A message that could not become a value.
   *
   * @param port of the stream
   * @param reason a sentence for users, naming the cause
   */
  default void unreadable(String port, String reason) {}

  /**
   * How far it is, told every few thousand messages of the recording and once more at the end of the range.
   *
   * @param time all values before it have been given
   * @return false where no more is wanted: the reading ends
   */
  default boolean reached(long time) {
    return true;
  }
}
