package org.robotui.rfic.recording.internal.tool;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.robotui.rfic.recording.internal.send.SendPace;

/**
 * What was asked of {@code log play}.
 *
 * @param file the recording
 * @param part what of it
 * @param pace how fast, and how often
 * @param clock whether the time of the recording is said
 * @param types where types of LCM are declared
 */
record PlayCommand(Path file, Part part, SendPace pace, boolean clock, List<Path> types) {
  static final String VERB = "play";
  private static final double SLOWEST = 0.001;
  private static final double FASTEST = 1000;
  /** As of rosbag. */
  private static final double DELAY_SECONDS = 0.2;
  private static final double LONGEST_SECONDS = 3600;
  private static final double NANOS = 1e9;

  /**
   * A part of a recording.
   *
   * @param begin from when on
   * @param end until when
   * @param topics patterns of its topics; none for all
   */
  record Part(Optional<LogTime> begin, Optional<LogTime> end, List<Pattern> topics) {}

  /** The words behind the verb. */
  static PlayCommand of(List<String> arguments) throws UsageException {
    LogOptions words = new LogOptions(VERB, arguments);
    boolean clock = words.flag("--clock");
    boolean loop = words.flag("--loop");
    boolean waits = words.flag("--wait-for-subscribers");
    double rate = words.number("--rate", SLOWEST, FASTEST).orElse(1.0);
    double delay = words.number("--delay", 0, LONGEST_SECONDS).orElse(DELAY_SECONDS);
    Part part = new Part(words.time("--from"), words.time("--to"), words.patterns("--topics"));
    List<Path> types = words.paths("--types");
    List<Path> files = words.files();
    if (files.size() != 1) {
      throw new UsageException("log play takes one file");
    }
    return new PlayCommand(files.getFirst(), part,
        new SendPace(rate, loop, Duration.ofNanos(Math.round(delay * NANOS)), waits), clock, types);
  }
}
