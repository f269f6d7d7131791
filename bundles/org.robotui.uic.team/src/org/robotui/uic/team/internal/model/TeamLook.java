package org.robotui.uic.team.internal.model;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.robotui.api.port.InputState;

/**
 * What is to be shown.
 *
 * @param rows all robots, in the order of the configuration
 * @param selected the robots that the user means
 * @param state of the view as a whole
 */
public record TeamLook(List<TeamRow> rows, Set<String> selected, InputState state) {
  /** Before the first tick. */
  public static final TeamLook NONE =
      new TeamLook(List.of(), Set.of(), new InputState.Waiting("The view has not looked for robots yet."));

  /** Copies the list. */
  public TeamLook {
    rows = List.copyOf(rows);
  }

  /** The robots with all these words, in any of their columns. */
  public List<TeamRow> matching(String words) {
    List<String> parts = List.of(words.strip().toLowerCase(Locale.ROOT).split("\\s+"));
    return words.isBlank() ? rows : rows.stream().filter(r -> r.matches(parts)).toList();
  }

  /** How many do what, such as {@code 50 robots · 34 driving · 1 lost}. */
  public String note() {
    Map<Activity, Integer> counts = new EnumMap<>(Activity.class);
    rows.forEach(r -> counts.merge(r.doing(), 1, Integer::sum));
    List<String> parts = new ArrayList<>(List.of(rows.size() == 1 ? "1 robot" : rows.size() + " robots"));
    counts.forEach((doing, count) -> parts.add(count + " " + doing.word()));
    return String.join("  \u00b7  ", parts);
  }
}
