package org.robotui.condition;

import java.util.List;
import java.util.OptionalDouble;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.status.LogEntry;

/** What a robot said, as conditions look at it: now, or at a time of a recording. */
public interface Signals {
  /**
   * What a source gives.
   *
   * @param name its name
   * @param state its state
   * @param newest its newest values, merged for keyed types; at most one
   * @param delaySeconds how long after its stamp the newest one came; none where it has no stamp of a clock that is
   * known
   */
  record Reading(String name, InputState state, List<Envelope<? extends Data>> newest, OptionalDouble delaySeconds) {
    /**
     * Copies the list.
     *
     * @param name its name
     * @param state its state
     * @param newest its newest values
     * @param delaySeconds how long after its stamp the newest one came
     */
    public Reading {
      newest = List.copyOf(newest);
    }
  }

  /**
   * The sources that a name means.
   *
   * @param name as it is written in a condition
   * @return those that the robot offers
   */
  List<Reading> readings(SourceName name);

  /**
   * The sources of a data type.
   *
   * @param typeName for example {@code Diagnostics}
   * @return those that the robot offers
   */
  List<Reading> readings(String typeName);

  /**
   * What the robot's programs have logged.
   *
   * @return the entries since the last look
   */
  List<LogEntry> log();

  /**
   * The link to the robot.
   *
   * @return as it is now
   */
  LinkState link();
}
