package org.robotui.uic.status.internal;

import java.util.stream.Stream;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.ui.Health;

/** Lines of links, and of components that failed. */
final class LinkRows {
  private LinkRows() {}

  static Stream<Row> of(ComponentStatus component) {
    if (component.state() == RuicState.FAILED) {
      return Stream.of(row(component, Health.BAD, "failed", component.reason()));
    }
    return component.link().map(link -> row(component, health(link), link.word(), text(link))).stream();
  }

  static Health health(LinkState link) {
    return switch (link) {
      case LinkState.Connected c -> Health.OK;
      case LinkState.Degraded d -> Health.WARNING;
      case LinkState.Connecting c -> Health.WAITING;
      case LinkState.Failed f -> Health.BAD;
      case LinkState.Disconnected d -> Health.NONE;
    };
  }

  private static String text(LinkState link) {
    return link instanceof LinkState.Connected connected ? connected.peer() : link.reason();
  }

  private static Row row(ComponentStatus component, Health health, String word, String text) {
    String name = component.kind() == ComponentStatus.Kind.RFIC ? component.id() + " \u00b7 " + component.type() : component.id();
    return new Row.Item("component " + component.id(), health, name, word, "", "", text, name + "\n" + word + "\n" + text);
  }
}
