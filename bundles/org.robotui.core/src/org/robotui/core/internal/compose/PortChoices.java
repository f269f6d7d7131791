package org.robotui.core.internal.compose;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.port.SourceId;

/**
 * The ports of robots that are there now, to be chosen from where a port is written. Others can be written as well: a
 * robot may not be connected yet.
 *
 * @param robots what is known of the robot UIs
 */
record PortChoices(List<RuicSnapshot> robots) {
  /** Ports of the interfaces of a robot UI, such as {@code base.scan}. */
  List<String> of(String ruic) {
    return robots.stream().filter(r -> r.name().equals(ruic)).flatMap(PortChoices::ports).map(SourceId::toString)
        .distinct().sorted().toList();
  }

  /** What may be written in place of a type, with ports to choose from. */
  static ValueType among(List<String> ports, ValueType type) {
    return ports.isEmpty() ? type : new ValueType.AnyOf(List.of(type, new ValueType.Choice(ports)));
  }

  /** The words of a bridge, its ends with the ports of all robot UIs. */
  Schema ends(Schema bridge, Set<String> ends) {
    List<String> ports = robots.stream().flatMap(PortChoices::ends).distinct().sorted().toList();
    return new Schema(bridge.settings().stream().map(s -> ends.contains(s.name())
        ? new Setting(s.name(), among(ports, s.type()), s.fallback(), s.required(), s.help())
        : s).toList());
  }

  /** With the name of the interface where there are several. */
  private static Stream<String> ends(RuicSnapshot robot) {
    boolean several = interfaces(robot).size() > 1;
    return ports(robot).map(p -> robot.name() + "." + (several ? p : p.port()));
  }

  private static Stream<SourceId> ports(RuicSnapshot robot) {
    Set<String> interfaces = interfaces(robot);
    return robot.ports().stream().map(p -> p.port()).filter(p -> interfaces.contains(p.component()));
  }

  private static Set<String> interfaces(RuicSnapshot robot) {
    return robot.components().stream().filter(c -> c.kind() == ComponentStatus.Kind.RFIC).map(ComponentStatus::id)
        .collect(Collectors.toUnmodifiableSet());
  }
}
