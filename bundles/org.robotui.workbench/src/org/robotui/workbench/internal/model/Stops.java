package org.robotui.workbench.internal.model;

import java.util.List;
import org.robotui.api.command.Authority;

/**
 * Which robots there are, and which of them are stopped.
 *
 * @param robots all that can be stopped, each once
 * @param stopped those that are
 */
public record Stops(List<String> robots, List<String> stopped) {
  /** As many are named; of more their number is said. */
  private static final int NAMED = 3;

  public Stops {
    robots = List.copyOf(robots);
    stopped = List.copyOf(stopped);
  }

  /** Asks the robots of all RUICs; several RUICs may show the same one. */
  public static Stops of(List<Authority> authorities) {
    return new Stops(authorities.stream().map(Authority::robot).distinct().toList(),
        authorities.stream().filter(a -> a.stoppedBy().isPresent()).map(Authority::robot).distinct().toList());
  }

  /** Whether any robot is stopped. */
  public boolean any() {
    return !stopped.isEmpty();
  }

  /** Whether there is nothing left to stop. */
  public boolean all() {
    return any() && stopped.size() == robots.size();
  }

  /** Which are stopped, where that is a question: empty for none, and where there is only one robot. */
  public String words() {
    return any() && robots.size() > 1 ? "Stopped: " + names() : "";
  }

  /** What releases them. */
  public String release() {
    return "Release " + (stopped.size() == 1 ? stopped.getFirst() : "all");
  }

  /** Whom that releases. */
  public String releaseHint() {
    return "Release the stop of " + names() + "; nothing moves by that";
  }

  /** What the button says that stops all robots: as long as one of them can move, that it stops. */
  public String button() {
    return all() ? "STOPPED" : any() ? "STOP ALL  (F12)" : "STOP  (F12)";
  }

  private String names() {
    return stopped.size() <= NAMED ? String.join(", ", stopped) : stopped.size() + " of " + robots.size() + " robots";
  }
}
