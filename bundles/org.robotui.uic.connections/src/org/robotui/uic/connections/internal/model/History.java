package org.robotui.uic.connections.internal.model;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;

/** Remembers since when components are as they are. Used by the tick only. */
final class History {
  private static final double NANOS = 1e-9;

  private record State(Object what, long since, boolean seen) {}

  private final Map<String, State> states = new HashMap<>();

  Since since(String key, ComponentStatus component, long now) {
    Object what = what(component);
    State next = states.compute(key, (k, before) -> before == null ? new State(what, now, false)
        : before.what().equals(what) ? before : new State(what, now, true));
    return new Since((now - next.since()) * NANOS, next.seen());
  }

  void keep(Set<String> keys) {
    states.keySet().retainAll(keys);
  }

  /** What counts as the same state: the time until the next attempt does not. */
  private static Object what(ComponentStatus component) {
    if (component.state() == RuicState.FAILED) {
      return "failed " + component.reason();
    }
    return component.link().map(History::what).orElse("none");
  }

  private static String what(LinkState link) {
    return switch (link) {
      // An attempt in between does not end a failure, and each attempt may fail with other words.
      case LinkState.Failed f -> "down";
      case LinkState.Connecting c -> "down";
      default -> link.word() + " " + link.reason();
    };
  }
}
