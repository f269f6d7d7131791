package org.robotui.workbench.internal.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.host.CompositionState;
import org.robotui.api.host.Match;
import org.robotui.api.host.RuicFit;
import org.robotui.api.host.ViewFit;
import org.robotui.api.host.ViewFit.Fit;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Health;

/**
 * A view that may be chosen, or below it one of its ports that several ports of the robot fit.
 *
 * @param key what identifies the row
 * @param view the type of view
 * @param port the port to be chosen; none in the row of a view
 * @param chosen whether the view is chosen
 * @param label what users read
 * @param hint what it is for
 * @param health what to think of it
 * @param state a word
 * @param why the reason
 * @param candidates the ports that the user can choose
 */
public record NewViewRow(String key, String view, Optional<SourceId> port, boolean chosen, String label, String hint,
    Health health, String state,
    String why, List<SourceId> candidates) {

  /**
   * Rows: the views of the type of RUIC that fit, then others that fit, then what does not; {@code decided} are ports
   * that the user has chosen.
   */
  public static List<NewViewRow> of(CompositionState state, RuicFit ruic, List<String> chosen,
      Map<SourceId, SourceId> connections,
      Set<SourceId> decided) {
    List<NewViewRow> rows = new ArrayList<>();
    state.views().stream()
        .sorted(Comparator.comparing((ViewFit v) -> !v.fits()).thenComparing(v -> !ruic.views().contains(v.type()))
            .thenComparing(v -> place(ruic, v)))
        .forEach(view -> {
          boolean taken = chosen.contains(view.type());
          rows.add(of(view, ruic, taken, decided));
          if (taken) {
            view.choices().forEach(m -> rows.add(of(view, m, connections, decided.contains(m.port()))));
          }
        });
    return rows;
  }

  private static int place(RuicFit ruic, ViewFit view) {
    int index = ruic.views().indexOf(view.type());
    return index < 0 ? Integer.MAX_VALUE : index;
  }

  private static NewViewRow of(ViewFit view, RuicFit ruic, boolean chosen, Set<SourceId> decided) {
    boolean more = view.fits() && !ruic.views().contains(view.type());
    boolean settled =
        view.fit() == Fit.AMBIGUOUS && view.choices().stream().map(Match::port).allMatch(decided::contains);
    Fit fit = settled ? Fit.CONNECTED : view.fit();
    return new NewViewRow(view.type(), view.type(), Optional.empty(), chosen, view.label(), view.help(), health(fit),
        word(fit),
        (more ? "not part of " + ruic.label() + "; " : "") + view.reason(), List.of());
  }

  private static NewViewRow of(ViewFit view, Match match, Map<SourceId, SourceId> connections, boolean decided) {
    SourceId peer = connections.getOrDefault(match.port(), match.candidates().getFirst());
    return new NewViewRow(match.port().toString(), view.type(), Optional.of(match.port()), true, match.port().port(),
        match.typeName(),
        decided ? Health.OK : Health.WARNING, decided ? "chosen" : "choose",
        peer.port() + " is taken; " + match.candidates().size() + " fit: press to choose another", match.candidates());
  }

  private static Health health(Fit fit) {
    return switch (fit) {
      case CONNECTED -> Health.OK;
      case AMBIGUOUS -> Health.WARNING;
      case PENDING -> Health.WAITING;
      case MISSING -> Health.NONE;
    };
  }

  private static String word(Fit fit) {
    return switch (fit) {
      case CONNECTED -> "connected";
      case AMBIGUOUS -> "ambiguous";
      case PENDING -> "pending";
      case MISSING -> "does not fit";
    };
  }
}
