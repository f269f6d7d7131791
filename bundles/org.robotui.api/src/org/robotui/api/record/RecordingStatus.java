package org.robotui.api.record;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;

/**
 * How a recording is doing, at one moment.
 *
 * @param files all of it, the one that is being written last
 * @param since when it was begun
 * @param bytes the size of all files so far
 * @param messages how many were written
 * @param dropped how many could not be taken in time
 * @param channels of what it consists, in the order in which they came
 * @param diskLeft bytes that are left where it lies
 * @param problems sentences for users, the gravest first; empty where all is well
 * @param leftOut streams that are recorded only where a choice names them, and none does: {@code base.cycles}
 */
public record RecordingStatus(List<Path> files, Instant since, long bytes, long messages, long dropped,
    List<Channel> channels, long diskLeft, List<String> problems, List<String> leftOut) {
  /**
   * One topic of one robot.
   *
   * @param robot name of its robot UI
   * @param topic the robot's name of it
   * @param type of its messages
   * @param messages how many were written
   * @param bytes of these, before they were made smaller
   * @param dropped how many could not be taken in time
   */
  public record Channel(String robot, String topic, String type, long messages, long bytes, long dropped) {}

  /**
   * Copies the lists.
   *
   * @param files all of it
   * @param since when it was begun
   * @param bytes the size of all files
   * @param messages how many were written
   * @param dropped how many could not be taken
   * @param channels of what it consists
   * @param diskLeft bytes that are left
   * @param problems sentences for users
   * @param leftOut streams that are recorded only on request
   */
  public RecordingStatus {
    leftOut = List.copyOf(leftOut);
    files = List.copyOf(files);
    channels = List.copyOf(channels);
    problems = List.copyOf(problems);
  }

  /**
   * Of a recording that leaves nothing out.
   *
   * @param files all of it
   * @param since when it was begun
   * @param bytes the size of all files
   * @param messages how many were written
   * @param dropped how many could not be taken
   * @param channels of what it consists
   * @param diskLeft bytes that are left
   * @param problems sentences for users
   */
  public RecordingStatus(List<Path> files, Instant since, long bytes, long messages, long dropped,
      List<Channel> channels, long diskLeft, List<String> problems) {
    this(files, since, bytes, messages, dropped, channels, diskLeft, problems, List.of());
  }

  /**
   * The file that is being written, or was last.
   *
   * @return the last of all
   */
  public Path file() {
    return files.getLast();
  }
}
