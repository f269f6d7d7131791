package org.robotui.workbench.internal.timeline;

import java.util.List;
import java.util.Locale;
import org.robotui.api.replay.FoundEvent;
import org.robotui.ui.Health;

/**
 * How a search stands.
 *
 * @param condition what is searched for; empty before the first search
 * @param running whether it goes on
 * @param share how far it is, 0 to 1
 * @param events what was found so far
 * @param more how many were found beyond those
 * @param problems what could not be looked at, sentences
 * @param failure why there is no answer; empty where nothing failed
 */
record FoundEvents(String condition, boolean running, double share, List<FoundEvent> events, long more,
    List<String> problems, String failure) {
  static final FoundEvents NONE = new FoundEvents("", false, 0, List.of(), 0, List.of(), "");

  /** A search that begins. */
  static FoundEvents begun(String condition) {
    return new FoundEvents(condition, true, 0, List.of(), 0, List.of(), "");
  }

  FoundEvents at(double now, List<FoundEvent> found, long beyond) {
    return new FoundEvents(condition, true, now, List.copyOf(found), beyond, problems, failure);
  }

  FoundEvents ended(List<String> missed) {
    return new FoundEvents(condition, false, share, events, more, List.copyOf(missed), "");
  }

  FoundEvents failed(String why) {
    return new FoundEvents(condition, false, share, events, more, problems, why);
  }

  /** In a line, for users. */
  String words() {
    if (condition.isEmpty()) {
      return "";
    }
    if (!failure.isEmpty()) {
      return failure;
    }
    String count = count(events.size() + more);
    String kept = more > 0 ? ", of which the first " + events.size() + " are shown" : "";
    String missed = problems.isEmpty() ? "" : "; " + String.join("; ", problems);
    return running ? String.format(Locale.ROOT, "%.0f %%, %s", 100 * share, count + kept)
        : (share < 1 ? "stopped at " + Math.round(100 * share) + " %, " : "") + count + kept + missed;
  }

  Health health() {
    return !failure.isEmpty() ? Health.BAD : problems.isEmpty() ? Health.NONE : Health.WARNING;
  }

  private static String count(long count) {
    return count == 0 ? "nothing found" : count == 1 ? "1 event found" : count + " events found";
  }
}
