package org.robotui.rfic.recording.internal.time;

/** What who reads a recording has to do next. */
public sealed interface Turn {
  /** The time of the next message has come: it is to be delivered. */
  record Deliver() implements Turn {}

  /**
   * The recording was moved: what holds at that time is to be delivered.
   *
   * @param time of the file
   */
  record Moved(long time) implements Turn {}

  /** Other topics are wanted than before. */
  record Look() implements Turn {}

  /** It is over. */
  record Over() implements Turn {}
}
