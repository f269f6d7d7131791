package org.robotui.headless.internal;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;

/** A RUIC in a few lines, for those without a text view of their own. */
final class Summary {
  private Summary() {}

  static List<String> lines(RuicSnapshot ruic) {
    return Stream.concat(Stream.of(head(ruic)), ruic.ports().stream().map(Summary::port)).toList();
  }

  private static String head(RuicSnapshot ruic) {
    if (ruic.state() == RuicState.ADDED) {
      return ruic.name() + "  not started  it starts when it is shown: --show " + ruic.name();
    }
    String reason = ruic.reason().isEmpty() ? ruic.link().reason() : ruic.reason();
    return ruic.name() + "  " + ruic.state().name().toLowerCase(Locale.ROOT) + "  " + ruic.link().word()
        + (reason.isEmpty() ? "" : "  " + reason);
  }

  private static String port(PortStatus port) {
    return String.format(Locale.ROOT, "  %-32s %-18s %8s %9s  %s", port.port(), port.typeName(),
        port.count() == 0 ? "-" : String.format(Locale.ROOT, "%.1f Hz", port.rateHz()), age(port), said(port));
  }

  private static String age(PortStatus port) {
    if (Double.isNaN(port.ageSeconds())) {
      return "-";
    }
    return String.format(Locale.ROOT, "%s%.1f s", port.stale() ? "stale " : "", port.ageSeconds());
  }

  private static String said(PortStatus port) {
    return port.problem().isEmpty() ? port.value() : port.problem();
  }

  /**
   * Why a component is not there; a view for a window that is not even installed where there is none has not failed.
   */
  static String failure(ComponentStatus component) {
    String name = "  " + component.id() + " (" + component.type() + ") ";
    boolean windowed = component.kind() == ComponentStatus.Kind.UIC
        && component.reason().startsWith("type '" + component.type() + "' is not installed");
    return name + (windowed ? "is not shown in a terminal: it needs a window"
        : component.state().name().toLowerCase(Locale.ROOT) + ": " + component.reason());
  }
}
