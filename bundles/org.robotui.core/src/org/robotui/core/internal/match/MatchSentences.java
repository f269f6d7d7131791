package org.robotui.core.internal.match;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.robotui.api.port.Port;
import org.robotui.api.port.PortKind;

/** The sentences of matching. */
final class MatchSentences {
  private static final int LISTED = 8;

  private MatchSentences() {}

  /** For example {@code map needs GridMap on 'map'}. */
  static String need(Want want) {
    return want.id().component() + " " + verb(want.port().kind()) + " " + want.port().typeName() + " on '"
        + want.port().name() + "'";
  }

  private static String verb(PortKind kind) {
    return switch (kind) {
      case STREAM -> "needs";
      case COMMAND -> "sends";
      case CALL -> "calls";
      case BROWSE -> "browses";
    };
  }

  /** For example {@code base offers LaserScan 'scan', Odometry 'odom'}. */
  static String offer(String component, PortKind kind, List<Have> haves) {
    List<Have> own = haves.stream()
        .filter(h -> h.id().component().equals(component) && h.port().kind() == kind).toList();
    String list = own.stream().limit(LISTED).map(h -> port(h.port())).collect(Collectors.joining(", "));
    String more = own.size() > LISTED ? " and " + (own.size() - LISTED) + " more" : "";
    String verb = kind == PortKind.COMMAND ? "accepts" : kind == PortKind.CALL ? "answers" : "offers";
    return own.isEmpty() ? component + " has no " + word(kind) : component + " " + verb + " " + list + more;
  }

  static String port(Port port) {
    return port.typeName() + " '" + port.name() + "'";
  }

  static String word(PortKind kind) {
    return kind == PortKind.BROWSE ? "browser" : kind.name().toLowerCase(Locale.ROOT);
  }

  /** The name without the robot's namespaces: {@code /robot/scan} is {@code scan}. */
  static String lastSegment(String name) {
    return name.substring(name.lastIndexOf('/') + 1);
  }
}
