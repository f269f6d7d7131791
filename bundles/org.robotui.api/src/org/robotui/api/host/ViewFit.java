package org.robotui.api.host;

import java.util.List;

/**
 * How well a type of view fits what a robot offers.
 *
 * @param type its id
 * @param label the name that users read
 * @param help what it is for
 * @param fit in a word
 * @param reason a sentence for users
 * @param matches what matching says of each of its ports
 */
public record ViewFit(String type, String label, String help, Fit fit, String reason, List<Match> matches) {
  /** In a word. */
  public enum Fit {
    /** It would show something. */
    CONNECTED,
    /** It would, once somebody says to which of several ports it is connected. */
    AMBIGUOUS,
    /** What it needs may still come. */
    PENDING,
    /** The robot offers nothing for it. */
    MISSING
  }

  /**
   * Copies the list.
   *
   * @param type its id
   * @param label the name
   * @param help what it is for
   * @param fit in a word
   * @param reason a sentence
   * @param matches of its ports
   */
  public ViewFit {
    matches = List.copyOf(matches);
  }

  /**
   * Whether it is of use for the robot.
   *
   * @return true also where a port is to be chosen
   */
  public boolean fits() {
    return fit == Fit.CONNECTED || fit == Fit.AMBIGUOUS;
  }

  /**
   * The ports for which somebody has to choose.
   *
   * @return in the order of its ports
   */
  public List<Match> choices() {
    return matches.stream().filter(m -> m.state() == MatchState.AMBIGUOUS).toList();
  }
}
