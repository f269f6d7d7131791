package org.robotui.ui.ask;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.robotui.api.UicContext;
import org.robotui.api.host.Match;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;

/** Whether there is a robot that can be asked and that answers, and if not: why. Safe for all threads. */
public final class Presence {
  private static final InputState LIVE = new InputState.Live(0, 0);

  private final UicContext context;
  private final BrowsePort port;
  private final String sought;

  /**
   * With the port over which robots are asked.
   *
   * @param context of the view
   * @param port which robots can be asked
   * @param sought what they are asked for, such as "its parameters"
   */
  public Presence(UicContext context, BrowsePort port, String sought) {
    this.context = context;
    this.port = port;
    this.sought = sought;
  }

  /**
   * How it is now.
   *
   * @param known the robots that have ever answered
   * @param failures why robots did not answer, by robot
   * @return live where one of the connected robots is known, else what to wait for or what is wrong
   */
  public InputState state(Set<String> known, Map<String, String> failures) {
    List<String> robots = context.browse(port).robots().stream().map(robot -> robot.source().component()).toList();
    if (robots.isEmpty()) {
      return new InputState.Unconnected(reason());
    }
    if (robots.stream().anyMatch(known::contains)) {
      return LIVE;
    }
    return robots.stream().filter(failures::containsKey).findFirst()
        .<InputState>map(robot -> new InputState.Failed(failure(robot, failures.get(robot))))
        .orElseGet(() -> new InputState.Waiting("Asking " + String.join(" and ", robots) + " for " + sought + "."));
  }

  /**
   * What is wrong although there is something to show.
   *
   * @param state how it is
   * @param failures why robots did not answer, by robot
   * @return a sentence, empty where nothing is wrong or where the state says it already
   */
  public static String notice(InputState state, Map<String, String> failures) {
    return state instanceof InputState.Live
        ? failures.entrySet().stream().map(e -> failure(e.getKey(), e.getValue())).sorted().findFirst().orElse("")
        : "";
  }

  private static String failure(String robot, String why) {
    return robot + " does not answer: " + why;
  }

  private String reason() {
    SourceId id = new SourceId(context.instance(), port.name());
    return context.ruic().snapshot().matches().stream()
        .filter(match -> match.port().equals(id)).map(Match::reason).filter(why -> !why.isBlank()).findFirst()
        .orElse("No robot here can be asked for " + sought + ".");
  }
}
