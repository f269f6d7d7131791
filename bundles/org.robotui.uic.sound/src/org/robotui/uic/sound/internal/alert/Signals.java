package org.robotui.uic.sound.internal.alert;

import java.util.List;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.status.LogEntry;

/** What a robot said, as conditions look at it. */
public interface Signals {
  /**
   * What a source gives.
   *
   * @param name its name
   * @param state its state
   * @param newest its newest values, merged for keyed types; at most one
   */
  record Reading(String name, InputState state, List<Envelope<? extends Data>> newest) {}

  /** The sources that a name means and that the robot offers. */
  List<Reading> readings(SourceName name);

  /** The sources of a data type. */
  List<Reading> readings(String typeName);

  /** The log entries since the last look. */
  List<LogEntry> log();

  /** The link to the robot. */
  LinkState link();
}
