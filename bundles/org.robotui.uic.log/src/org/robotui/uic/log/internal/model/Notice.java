package org.robotui.uic.log.internal.model;

import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;

/**
 * What the view has to say beside or in place of its list. Pure.
 *
 * @param health its dot
 * @param title a few words
 * @param sentence what is so and what would help
 */
public record Notice(Health health, String title, String sentence) {
  /** What stands in place of the list, where it has no rows; none also where the state of the input says it all. */
  public static Optional<Notice> inPlace(Shown shown, InputState state) {
    if (!shown.lines().isEmpty() || shown.kept() == 0 && !StateView.showsContent(state)) {
      return Optional.empty();
    }
    if (shown.kept() == 0) {
      return Optional.of(shown.cleared() ? new Notice(Health.NONE, "Cleared", "Nothing was said since.")
          : new Notice(Health.WAITING, "No log entries yet", "The log is connected; its entries appear here."));
    }
    if (shown.left() > 0) {
      return Optional.of(new Notice(Health.WAITING, "Searching", shown.left() + " entries are still to be looked at."));
    }
    if (shown.held() == shown.kept()) {
      return Optional.of(new Notice(Health.NONE, "Paused", shown.held() + " entries came meanwhile."));
    }
    return Optional.of(new Notice(Health.NONE, "No match",
        shown.kept() + " entries are hidden by " + shown.filter().words()
            + ". \u201cShow all\u201d brings them back."));
  }

  /** What is said above the rows: a bad search, or that nothing new can come. */
  public static Optional<Notice> above(Shown shown, InputState state) {
    String problem = shown.filter().search().problem();
    if (!problem.isEmpty()) {
      return Optional.of(new Notice(Health.BAD, "search", problem));
    }
    if (shown.kept() == 0 || state instanceof InputState.Live) {
      return Optional.empty();
    }
    return Optional.of(new Notice(StateView.health(state), StateView.word(state), state.explanation()));
  }

  /** The short text of the view's title line. */
  public static String title(Shown shown) {
    StringBuilder text = new StringBuilder();
    text.append(shown.lines().size() == shown.kept() ? count(shown.kept())
        : count(shown.lines().size()) + " of " + count(shown.kept()));
    if (shown.rateHz() > 0) {
      text.append("  ").append(org.robotui.ui.Figures.of(shown.rateHz(), shown.rateHz() < 10 ? 1 : 0, "/s"));
    }
    if (shown.dropped() > 0) {
      text.append("  ").append(count(shown.dropped())).append(" lost");
    }
    if (shown.left() > 0) {
      text.append("  searching ").append(count(shown.left())).append(" more");
    }
    return text.toString();
  }

  private static String count(long number) {
    return String.format(java.util.Locale.ROOT, "%,d", number).replace(',', '\u00a0');
  }
}
