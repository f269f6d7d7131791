package org.robotui.uic.diagnostics.internal.view;

import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.uic.diagnostics.internal.model.Ask;
import org.robotui.uic.diagnostics.internal.model.Shown;

/**
 * What is painted next; immutable.
 *
 * @param shown the parts, as the last tick left them
 * @param ask what was asked for, which the parts may not follow yet
 * @param state of the input
 */
public record Frame(Shown shown, Ask ask, InputState state) {
  /**
   * What stands in place of the tree.
   *
   * @param health its dot
   * @param title a few words
   * @param sentence what is so and what would help
   */
  record Notice(Health health, String title, String sentence) {}

  /** What stands in place of the tree where it is empty; none also where the state of the input says it all. */
  Optional<Notice> notice() {
    if (!shown.rows().isEmpty() || shown.parts() == 0 && !StateView.showsContent(state)) {
      return Optional.empty();
    }
    if (shown.parts() == 0) {
      return Optional.of(new Notice(Health.WAITING, "Nothing reported yet",
          "The diagnostics are connected; what they report appears here."));
    }
    if (shown.ask().search().isBlank()) {
      return Optional.of(new Notice(Health.OK, "No problems",
          shown.parts() == 1 ? "The one part is OK." : "All " + shown.parts() + " parts are OK."));
    }
    return Optional
        .of(new Notice(Health.NONE, "No match", (shown.ask().problems() ? "No part with a problem" : "No part")
            + " contains \u201c" + shown.ask().search().strip() + "\u201d."));
  }

  /** How the tree is shown: what is known stays in sight, faded, where nothing new can come. */
  InputState treeState() {
    if (shown.parts() == 0 || state instanceof InputState.Live || state instanceof InputState.Stale) {
      return state;
    }
    return new InputState.Stale(secondsSilent(), state.explanation());
  }

  private double secondsSilent() {
    return Math.max(0, shown.now() * 1e-9 - shown.newestReport());
  }

  /** The short text of the view's title line. */
  String title() {
    if (shown.parts() == 0) {
      return "";
    }
    String link = state instanceof InputState.Live ? "" : "  " + StateView.word(state);
    String refused = shown.refused() == 0 ? "" : "  more parts than can be kept";
    return shown.parts() + (shown.parts() == 1 ? " part" : " parts") + shown.source().map(s -> "  " + s).orElse("")
        + link + refused;
  }
}
