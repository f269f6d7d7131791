package org.robotui.uic.connections.internal.model;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.ComponentStatus.Kind;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;

/** Robots in all states, for tests. */
public final class Robots {
  /** A link that is up. */
  public static final LinkState UP = new LinkState.Connected("localhost:11311");
  /** A link that is down. */
  public static final LinkState DOWN =
      new LinkState.Failed("10.0.0.7:11311 refuses the connection", Duration.ofSeconds(4));

  private Robots() {}

  /** A robot whose camera view must be told which camera. */
  public static RuicSnapshot keira() {
    return robot("Keira", UP, List.of(
        stream("/scan", "LaserScan", true, 10, 0.012, false, 0, "", "min 0.42 m"),
        stream("/sonar", "RangeReadings", true, 12.5, 0.071, false, 14, "", "16 sensors"),
        stream("/amcl_pose", "PoseEstimate", true, 2, 4.2, true, 0, "", "\u03c3 0.04 m"),
        stream("/map", "GridMap", true, 0, Double.NaN, false, 0, "", ""),
        stream("/imu", "Imu", false, 0, Double.NaN, false, 0, "", ""),
        stream("/diagnostics", "Diagnostics", true, 0, Double.NaN, false, 0,
            "10.0.0.7:45123 sends foo/Diag, expected diagnostic_msgs/DiagnosticArray", "")),
        List.of(
            match("camera", "image", Arity.ONE, MatchState.AMBIGUOUS,
                "two ports fit; choose one of /front/image and /rear/image",
                List.of(), List.of(new SourceId("base", "/front/image"), new SourceId("base", "/rear/image"))),
            match("map", "scan", Arity.MANY, MatchState.CONNECTED, "", List.of(new SourceId("base", "/scan")),
                List.of()),
            match("map", "grid", Arity.OPTIONAL, MatchState.PENDING, "map waits for a GridMap; base offers none",
                List.of(), List.of()),
            match("teleop", "cmd_vel", Arity.ONE, MatchState.REFUSED,
                "teleop needs VelocityCommand on 'cmd_vel'; base offers LaserScan '/scan'", List.of(), List.of())));
  }

  /** A robot with some link and nothing else but a view. */
  public static RuicSnapshot plain(String name, LinkState link) {
    return robot(name, link, List.of(stream("/scan", "LaserScan", true, 10, 0.02, false, 0, "", "")),
        List.of(match("map", "scan", Arity.MANY, MatchState.CONNECTED, "", List.of(new SourceId("base", "/scan")),
            List.of())));
  }

  /** A robot with very many ports. */
  public static RuicSnapshot large(String name, int ports) {
    return robot(name, UP,
        IntStream.range(0, ports)
            .mapToObj(i -> stream("/topic_" + i, "LaserScan", true, 10, 0.01, false, 0, "", "min 0.42 m")).toList(),
        IntStream.range(0, ports).mapToObj(i -> match("view" + i % 10, "port" + i, Arity.ONE, MatchState.CONNECTED, "",
            List.of(new SourceId("base", "/topic_" + i)), List.of())).toList());
  }

  /** A robot of one robot interface and the views that its matches name. */
  public static RuicSnapshot robot(String name, LinkState link, List<PortStatus> ports, List<Match> matches) {
    List<ComponentStatus> components = new ArrayList<>();
    components.add(new ComponentStatus("base", "ros", Kind.RFIC, RuicState.SELECTED, "", Optional.of(link)));
    matches.stream().map(match -> match.port().component()).distinct().forEach(
        view -> components.add(new ComponentStatus(view, view, Kind.UIC, RuicState.SELECTED, "", Optional.empty())));
    return new RuicSnapshot(name, RuicState.SELECTED, "", link, components, ports, matches);
  }

  static PortStatus stream(
      String name, String type, boolean wanted, double rate, double age, boolean stale, long dropped, String problem,
      String value) {
    return new PortStatus(new SourceId("base", name), PortKind.STREAM, type, wanted, Double.isNaN(age) ? 0 : 100, rate,
        age,
        stale, dropped, problem, value);
  }

  static Match match(String view, String port, Arity arity, MatchState state, String reason, List<SourceId> peers,
      List<SourceId> candidates) {
    return new Match(new SourceId(view, port), PortKind.STREAM, "Image", arity, state, peers, candidates, reason);
  }
}
