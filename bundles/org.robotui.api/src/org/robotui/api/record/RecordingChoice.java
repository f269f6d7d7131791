package org.robotui.api.record;

import java.util.List;

/**
 * What is recorded. Names are patterns, in which {@code *} stands for any characters, {@code ?} for one, and
 * {@code {a,b}} for one of several; lists that are empty mean all, without what a robot sends for who chooses it alone
 * ({@link org.robotui.api.port.Intake#CHOSEN}).
 *
 * @param robots names of robots or of their UIs
 * @param ports names of streams, with or without that of their robot interface: {@code base.scan}, {@code scan},
 * {@code camera*}
 */
public record RecordingChoice(List<String> robots, List<String> ports) {
  /** All that all robots send. */
  public static final RecordingChoice ALL = new RecordingChoice(List.of(), List.of());

  /**
   * Copies the lists.
   *
   * @param robots names of robots
   * @param ports names of streams
   */
  public RecordingChoice {
    robots = List.copyOf(robots);
    ports = List.copyOf(ports);
  }
}
