package org.robotui.api.replay;

import java.nio.file.Path;
import java.util.List;

/**
 * An open recording on the timeline.
 *
 * @param id which
 * @param file where it was read
 * @param span from its first to its last message, in times of the timeline: with the offset
 * @param offset what is added to the times in the file, in nanoseconds
 * @param lanes its topics, sorted by name
 * @param problems what could not be read in it, a sentence each; empty where all is well
 */
public record Track(TrackId id, Path file, TimeRange span, long offset, List<Lane> lanes, List<String> problems) {
  /**
   * Copies the lists.
   *
   * @param id which
   * @param file where it was read
   * @param span its times
   * @param offset of its times
   * @param lanes its topics
   * @param problems sentences
   */
  public Track {
    lanes = List.copyOf(lanes);
    problems = List.copyOf(problems);
  }
}
