package org.robotui.api.replay;

import java.io.IOException;
import java.util.Optional;

/**
 * Finds out when something was so in the recordings that are open, whatever the timeline shows: an OSGi service, which
 * is there while recordings can be played. Conditions are those of alerts. Each recording is looked at by itself. Safe
 * for all threads.
 */
public interface RecordingSearch {
  /**
   * Reads a condition.
   *
   * @param condition for example {@code battery charge < 0.2 for 5 s}
   * @return what is wrong with it and what could be written; empty where it can be searched for
   */
  Optional<String> fault(String condition);

  /**
   * Searches in all recordings, one after another and from start to end. Blocks for the files: for a worker of who
   * asks. Nothing of what is found is kept.
   *
   * @param condition as for {@link #fault}
   * @param taker is given what is found, on this thread
   * @return what became of it
   * @throws IllegalArgumentException where the condition cannot be read, or no recording has what it names; the message
   * says what could be written
   * @throws IOException where a file cannot be read any more, or a recording was closed meanwhile
   * @throws InterruptedException where the thread was interrupted
   */
  SearchReport search(String condition, SearchTaker taker) throws IOException, InterruptedException;
}
