package org.robotui.uic.graph.internal.model;

import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.diagram.Diagram;

/**
 * All that is seen of the view.
 *
 * @param ask what was asked for
 * @param state whether a robot answers
 * @param diagram the newest layout, with rates
 * @param laying whether a newer one is being made
 * @param notice what is wrong although there is something to see
 * @param empty why there is nothing to see although a robot answers
 * @param selected all about what is selected, in a line
 * @param nodes how many nodes are shown, those in closed namespaces among them
 * @param topics how many topics
 */
public record GraphViewState(
    Ask ask,
    InputState state,
    Diagram diagram,
    boolean laying,
    Optional<String> notice,
    Optional<Empty> empty,
    String selected,
    int nodes,
    int topics) {
  /**
   * Why there is nothing to see.
   *
   * @param health its dot
   * @param title a few words
   * @param sentence what is so and what would help
   */
  public record Empty(Health health, String title, String sentence) {}

  /** The short text of the title line. */
  public String title() {
    return nodes == 0 ? ""
        : nodes + (nodes == 1 ? " node, " : " nodes, ") + topics + (topics == 1 ? " topic" : " topics")
            + (laying ? "  laying out\u2026" : "");
  }
}
