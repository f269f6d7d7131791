package org.robotui.api.replay;

/** Is given what is found. All on the thread that searches. */
public interface SearchTaker {
  /**
   * An event that is over, or that lasts until the end of its recording.
   *
   * @param event the next one of its recording, by its end
   */
  void found(FoundEvent event);

  /**
   * How far it is, told every few thousand messages.
   *
   * @param share of all recordings, 0 to 1
   * @return false where no more is wanted: the search ends
   */
  boolean reached(double share);
}
