package org.robotui.core.internal.match;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robotui.api.UicType;
import org.robotui.api.UicType.Surface;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.ViewFit;
import org.robotui.api.host.ViewFit.Fit;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Port;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;

/**
 * Says of types of views how well they fit what a robot offers. A pure function: the same matcher as for a RUIC that
 * runs.
 */
public final class ViewFits {
  private static final int NAMED = 3;

  private ViewFits() {}

  /** Of all that can be seen in a window: those that fit first. */
  public static List<ViewFit> of(List<UicType> types, List<Have> haves, List<Supplier> suppliers) {
    return types.stream().filter(t -> t.surface() == Surface.WINDOW).map(t -> of(t, haves, suppliers))
        .sorted(Comparator.comparing(ViewFit::fit).thenComparing(ViewFit::label)).toList();
  }

  private static ViewFit of(UicType type, List<Have> haves, List<Supplier> suppliers) {
    List<Port> ports = type.ports();
    List<Want> wants = ports.stream().map(p -> new Want(new SourceId(type.id(), p.name()), p)).toList();
    List<Match> matches = Matcher.match(wants, haves, suppliers, Map.of());
    List<Match> needed =
        IntStream.range(0, ports.size()).filter(i -> isNeeded(ports.get(i))).mapToObj(matches::get).toList();
    Fit fit = fit(ports.isEmpty(), needed, matches);
    return new ViewFit(type.id(), type.label(), type.help(), fit, reason(fit, needed, matches), matches);
  }

  /**
   * Without these the view has nothing to show: what it declares as one, and the browsers and calls by which it looks.
   */
  private static boolean isNeeded(Port port) {
    boolean asks = port.kind() == PortKind.BROWSE || port.kind() == PortKind.CALL;
    return port.arity() == Arity.ONE || asks && port.arity() != Arity.OPTIONAL;
  }

  private static Fit fit(boolean needsNothing, List<Match> needed, List<Match> all) {
    boolean missing = needed.isEmpty() ? !needsNothing && all.stream().noneMatch(ViewFits::isThere)
        : !needed.stream().allMatch(ViewFits::isThere);
    if (missing) {
      List<Match> open = needed.isEmpty() ? all : needed;
      return open.stream().anyMatch(m -> m.state() == MatchState.PENDING) ? Fit.PENDING : Fit.MISSING;
    }
    return all.stream().anyMatch(is(MatchState.AMBIGUOUS)) ? Fit.AMBIGUOUS : Fit.CONNECTED;
  }

  private static boolean isThere(Match match) {
    return match.state() == MatchState.CONNECTED || match.state() == MatchState.AMBIGUOUS;
  }

  private static Predicate<Match> is(MatchState state) {
    return m -> m.state() == state;
  }

  private static String reason(Fit fit, List<Match> needed, List<Match> all) {
    return switch (fit) {
      case CONNECTED -> all.isEmpty() ? "needs no port of the robot" : connected(all);
      case AMBIGUOUS -> all.stream().filter(is(MatchState.AMBIGUOUS))
          .map(m -> m.port().port() + ": " + m.candidates().size() + " ports fit").collect(Collectors.joining("; "));
      case PENDING, MISSING -> (needed.isEmpty() ? all : needed).stream().filter(m -> !isThere(m)).findFirst()
          .map(Match::reason).orElse("");
    };
  }

  /** For example {@code map from map:0, scan from laser:0 and 2 more}. */
  private static String connected(List<Match> all) {
    List<Match> there = all.stream().filter(is(MatchState.CONNECTED)).toList();
    String first = there.stream().limit(NAMED).map(ViewFits::connected).collect(Collectors.joining(", "));
    return there.size() > NAMED ? first + " and " + (there.size() - NAMED) + " more" : first;
  }

  private static String connected(Match match) {
    String name = match.port().port();
    if (match.peers().isEmpty()) {
      return name + " chooses among " + match.candidates().size();
    }
    String way = match.kind() == PortKind.STREAM ? " from " : " to ";
    String peers = match.peers().stream().limit(2).map(SourceId::port).collect(Collectors.joining(" and "));
    return name + way + peers + (match.peers().size() > 2 ? " and " + (match.peers().size() - 2) + " others" : "");
  }
}
