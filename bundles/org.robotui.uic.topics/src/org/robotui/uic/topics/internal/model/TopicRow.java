package org.robotui.uic.topics.internal.model;

import java.util.Optional;
import java.util.OptionalInt;
import org.robotui.ui.ask.Measure;

/**
 * A row of the list.
 *
 * @param entry the thing
 * @param label its name, after that of its robot where there are several
 * @param type the robot's name of its type, empty where not known
 * @param counts who uses it, where known
 * @param measured whether the user wants it measured
 * @param measure what was measured, where it is measured or echoed
 */
public record TopicRow(Entry entry, String label, String type, Counts counts, boolean measured,
    Optional<Measure> measure) {
  /**
   * Who uses a thing.
   *
   * @param publishers or servers, or what a node publishes
   * @param subscribers or clients, or what a node subscribes
   */
  public record Counts(OptionalInt publishers, OptionalInt subscribers) {
    /** Not known. */
    public static final Counts UNKNOWN = new Counts(OptionalInt.empty(), OptionalInt.empty());
  }

  /** Which one. */
  public Key key() {
    return entry.key();
  }
}
