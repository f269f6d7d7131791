package org.robotui.core.internal.config;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeEnd;

/**
 * Finds bridges that carry a value back to where it came from. One that carries both ways is no loop by itself, as a
 * robot interface does not hear what a bridge says there.
 */
final class BridgeLoops {
  private record Way(BridgeConfig bridge, BridgeEnd from, BridgeEnd to) {}

  private final List<Way> ways = new ArrayList<>();

  /** Adds a bridge, or says why it cannot be. */
  Optional<String> add(BridgeConfig bridge) {
    if (bridge.from().equals(bridge.to())) {
      return Optional.of("leads from " + bridge.from() + " to where it begins; name another port with 'to'");
    }
    List<Way> added = ways(bridge);
    Optional<String> fault = added.stream().flatMap(way -> fault(way).stream()).findFirst();
    if (fault.isEmpty()) {
      ways.addAll(added);
    }
    return fault;
  }

  private static List<Way> ways(BridgeConfig bridge) {
    Way forth = new Way(bridge, bridge.from(), bridge.to());
    return bridge.settings().flag("both") ? List.of(forth, new Way(bridge, bridge.to(), bridge.from()))
        : List.of(forth);
  }

  private Optional<String> fault(Way added) {
    Optional<Way> same =
        ways.stream().filter(w -> w.from().equals(added.from()) && w.to().equals(added.to())).findFirst();
    if (same.isPresent()) {
      return Optional.of("carries " + added.from() + " to " + added.to() + ", as '" + same.get().bridge().name()
          + "' does; leave one of them out");
    }
    return back(added.to(), added.from(), new HashSet<>()).map(rest -> "closes a loop: " + Stream.concat(
        Stream.of(added), rest.stream()).map(w -> w.from() + " -> ").collect(Collectors.joining()) + added.from()
        + " (by " + Stream.concat(Stream.of(added), rest.stream()).map(w -> "'" + w.bridge().name() + "'").distinct()
            .collect(Collectors.joining(", "))
        + "); leave one of them out, or 'both'");
  }

  /** The ways that lead from one end to another. */
  private Optional<List<Way>> back(BridgeEnd from, BridgeEnd to, Set<BridgeEnd> seen) {
    if (from.equals(to)) {
      return Optional.of(List.of());
    }
    if (!seen.add(from)) {
      return Optional.empty();
    }
    for (Way way : ways) {
      if (way.from().equals(from)) {
        Optional<List<Way>> rest = back(way.to(), to, seen);
        if (rest.isPresent()) {
          return Optional.of(Stream.concat(Stream.of(way), rest.get().stream()).toList());
        }
      }
    }
    return Optional.empty();
  }
}
