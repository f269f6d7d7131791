package org.robotui.uic.status.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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

/** Snapshots of a robot, for tests. */
final class Snapshots {
  static final LinkState UP = new LinkState.Connected("localhost:11311");

  private Snapshots() {}

  static RuicSnapshot of(LinkState link, List<PortStatus> ports, List<Match> matches) {
    return new RuicSnapshot("Keira", RuicState.SELECTED, "", link,
        List.of(new ComponentStatus("base", "ros", Kind.RFIC, RuicState.SELECTED, "", Optional.of(link))), ports,
        matches);
  }

  static PortStatus port(String name, String type, boolean wanted, double rate, double age, boolean stale, long dropped,
      String value) {
    return new PortStatus(new SourceId("base", name), PortKind.STREAM, type, wanted, Double.isNaN(age) ? 0 : 100, rate,
        age,
        stale, dropped, "", value);
  }

  static Match match(String view, String port, Arity arity, MatchState state, List<SourceId> peers, String reason) {
    return new Match(new SourceId(view, port), PortKind.STREAM, "Image", arity, state, peers, List.of(), reason);
  }

  static RuicSnapshot typical() {
    List<PortStatus> ports = new ArrayList<>(List.of(
        port("/scan", "LaserScan", true, 10, 0.012, false, 0, "min 0.42 m, 360 rays"),
        port("/odom", "Odometry", true, 50.1, 0.004, false, 0, "x 1.24 y \u22120.31 m, 0.23 m/s"),
        port("/sonar", "RangeReadings", true, 12.5, 0.071, false, 14, "16 sensors, min 0.31 m"),
        port("/amcl_pose", "PoseEstimate", true, 2, 4.2, true, 0, "\u03c3 0.04 m"),
        port("/map", "GridMap", true, 0, Double.NaN, false, 0, ""),
        port("/camera/image_raw/compressed", "Image", true, 30, 0.021, false, 0, "320\u00d7240 jpeg"),
        port("/rosout", "LogEntry", false, 0, Double.NaN, false, 0, ""),
        port("/imu/data", "Imu", false, 0, Double.NaN, false, 0, "")));
    ports.add(new PortStatus(new SourceId("base", "/diagnostics"), PortKind.STREAM, "Diagnostics", true, 0, 0,
        Double.NaN, false, 3,
        "10.0.0.7:45123 sends foo/Diag, expected diagnostic_msgs/DiagnosticArray", ""));
    ports.add(new PortStatus(new SourceId("base", "/cmd_vel"), PortKind.COMMAND, "VelocityCommand", true, 8, 20, 0.03,
        false, 0, "",
        "0.23 m/s, \u22120.18 rad/s"));
    return of(UP, ports, List.of(
        match("camera", "image", Arity.ONE, MatchState.AMBIGUOUS, List.of(),
            "two ports fit; choose one of base./camera/image_raw and natalie./image in the camera view"),
        match("map", "map", Arity.OPTIONAL, MatchState.PENDING, List.of(), "map waits for a GridMap; base offers none"),
        match("map", "scan", Arity.MANY, MatchState.CONNECTED, List.of(new SourceId("base", "/scan")), "")));
  }
}
