package org.robotui.uic.connections.internal.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicSnapshot;

/** Makes lines of what all RUICs say. Used by one thread at a time, the tick. */
public final class Survey {
  private final History history = new History();

  /** All that is to be shown. */
  public ConnectionsLook look(List<RuicSnapshot> ruics, List<BridgeStatus> bridges, long now) {
    Set<String> seen = new HashSet<>();
    List<ConnectionsLook.Branch> branches = ruics.stream().map(ruic -> branch(ruic, bridges, now, seen)).toList();
    history.keep(seen);
    return new ConnectionsLook(branches, Summary.of(ruics));
  }

  private ConnectionsLook.Branch branch(RuicSnapshot ruic, List<BridgeStatus> bridges, long now,
      Set<String> seen) {
    Map<String, List<ConnectionLine>> ports = ports(ruic, bridges);
    List<ConnectionLine.Part> parts = new ArrayList<>();
    for (ComponentStatus component : ruic.components()) {
      String key = ruic.name() + "\n" + component.id();
      seen.add(key);
      parts.add(new ConnectionLine.Part(ruic.name(), component, history.since(key, component, now),
          ports.getOrDefault(component.id(), List.of())));
    }
    int problems = (int) parts.stream().flatMap(part -> Stream.concat(Stream.of(part), part.ports().stream()))
        .filter(ConnectionLine::isProblem).count();
    return new ConnectionsLook.Branch(new ConnectionLine.Robot(ruic, problems), parts);
  }

  /** By component, in one pass: a RUIC may have very many. */
  private static Map<String, List<ConnectionLine>> ports(RuicSnapshot ruic, List<BridgeStatus> bridges) {
    Map<String, List<ConnectionLine>> lines = new HashMap<>();
    ruic.ports().forEach(port -> lines.computeIfAbsent(port.port().component(), id -> new ArrayList<>())
        .add(new ConnectionLine.RobotPort(ruic.name(), port)));
    ruic.matches().forEach(match -> lines.computeIfAbsent(match.port().component(), id -> new ArrayList<>())
        .add(new ConnectionLine.ViewPort(ruic.name(), match)));
    bridges.forEach(bridge -> List.of(bridge.from(), bridge.to()).stream().filter(end -> end.ruic().equals(ruic.name()))
        .forEach(end -> lines.computeIfAbsent(end.port().component(), id -> new ArrayList<>())
            .add(new BridgeLine(end, bridge))));
    return lines;
  }
}
