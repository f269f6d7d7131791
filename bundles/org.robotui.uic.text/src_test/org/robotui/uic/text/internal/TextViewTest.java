package org.robotui.uic.text.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.alert.AlertId;
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
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;

class TextViewTest {
  private final FakeUicContext context = new FakeUicContext("text", new TextType().schema());
  private final TextView view = new TextView(context);

  @Test
  void showsTheWholeRobotAtOneGlance() {
    snapshot(connected(), List.of(
        port("/scan", "LaserScan", 1200, 10.0, 0.012, false, 0, "", "min 0.42 m"),
        port("/odom", "Odometry", 6000, 50.1, 0.004, false, 3, "", "0.31 m/s"),
        port("/battery", "Battery", 60, 1.0, 2.1, true, 0, "no new value for 2.1 s; the link is up", "87 %"),
        port("/map", "GridMap", 0, 0, Double.NaN, false, 0, "", ""),
        port("/imu", "Imu", 0, 0, Double.NaN, false, 0, "the type is foo/Imu, expected sensor_msgs/Imu", "")),
        List.of(match(MatchState.PENDING, "camera needs Image on 'image'; base offers LaserScan '/scan'")));
    context.authority().take(FakeAuthority.YOU, false);
    assertEquals(List.of(
        "Keira  connected: localhost:11311                                     You drive",
        "  base (ros)  connected: localhost:11311",
        "",
        "state    port                rate     age dropped  value",
        "ok       base./scan       10.0 Hz   12 ms       0  min 0.42 m",
        "ok       base./odom       50.1 Hz    4 ms       3  0.31 m/s",
        "stale    base./battery     1.0 Hz   2.1 s       0  87 %",
        "waiting  base./map              -       -       0",
        "failed   base./imu              -       -       0  the type is foo/Imu, expect\u2026",
        "waiting  camera.image: camera needs Image on 'image'; base offers LaserScan '/\u2026"), lines(79, 24));
  }

  @Test
  void alertsStandAboveThePorts() {
    snapshot(connected(), List.of(port("/scan", "LaserScan", 1, 10, 0.01, false, 0, "", "v")), List.of());
    context.alerts().raise("Battery low", "battery charge < 0.2", "battery.charge", "0.18");
    context.alerts().raise("scan stale", "scan stale", "scan", "nothing for 4.2 s");
    context.alerts().mute(new AlertId("sound", "scan stale"), Optional.of(Instant.MAX));
    List<String> lines = lines(120, 24);
    assertTrue(lines.get(3).startsWith("ALERT    Battery low (battery charge < 0.2)  battery.charge: 0.18  since "),
        lines.toString());
    assertTrue(lines.get(3).endsWith(", on"), lines.toString());
    assertTrue(lines.get(4).startsWith("ALERT    scan stale  scan: nothing for 4.2 s  since "), lines.toString());
    assertTrue(lines.get(4).endsWith(", on, muted"), lines.toString());
    assertTrue(lines.get(6).startsWith("state"), lines.toString());
  }

  @Test
  void typesAreListedWhereThereIsRoom() {
    snapshot(connected(), List.of(port("/scan", "LaserScan", 1, 10, 0.01, false, 0, "", "v")), List.of());
    assertFalse(lines(80, 24).toString().contains("LaserScan"));
    assertTrue(lines(120, 24).toString().contains("LaserScan"));
    context.settings().set(TextType.TYPES, false);
    assertFalse(lines(120, 24).toString().contains("LaserScan"));
  }

  @Test
  void aLostLinkSaysWhyAndWhenItIsTriedAgain() {
    snapshot(new LinkState.Failed("localhost:11311 refuses the connection", Duration.ofSeconds(4)), List.of(),
        List.of());
    assertTrue(lines(80, 24).getFirst().startsWith("Keira  retry 4 s: localhost:11311 refuses the connection"));
    assertTrue(lines(80, 24).contains("no ports yet"));
  }

  @Test
  void aLatchedStopIsSaidAtTheSamePlaceAsTheLease() {
    context.authority().take(FakeAuthority.ANNA, false);
    assertTrue(lines(80, 24).getFirst().endsWith("  Anna has control"));
    context.authority().stop(FakeAuthority.YOU);
    assertTrue(lines(80, 24).getFirst().endsWith("  STOPPED by You"));
  }

  @Test
  void nothingIsWiderOrLongerThanTheTerminal() {
    List<PortStatus> many = IntStream.range(0, 90)
        .mapToObj(i -> port("/very/long/topic/name/of/a/robot/" + i, "LaserScan", 1, 10, 0.01, false, 0, "",
            "\u4f60\u597d".repeat(30)))
        .toList();
    snapshot(connected(), many, List.of(match(MatchState.REFUSED, "x".repeat(300)), match(MatchState.AMBIGUOUS, "y")));
    for (int columns = 0; columns < 200; columns += 7) {
      for (int rows = 0; rows < 110; rows += 3) {
        List<String> lines = lines(columns, rows);
        assertTrue(lines.size() <= rows, columns + " x " + rows);
        int width = columns;
        assertTrue(lines.stream().allMatch(line -> Columns.width(line) <= width),
            columns + " x " + rows + ": " + lines);
      }
    }
    assertTrue(lines(80, 24).contains("\u2026 " + (90 + 1 - 18) + " more ports"), lines(80, 24).toString());
    assertTrue(lines(80, 24).getLast().startsWith("ambiguous  camera.image: y"));
  }

  @Test
  void whatARobotSendsNeverReachesTheTerminalAsACommand() {
    String hostile = "\u001b[2J\u001b]0;owned\u0007\u202egnp.exe\u2028\u0085\u007f\r\n\ud800";
    snapshot(new LinkState.Degraded(hostile, hostile),
        List.of(port("/" + hostile, hostile, 1, 1, 1, false, 0, hostile, hostile)),
        List.of(match(MatchState.PENDING, hostile)));
    for (String line : lines(300, 50)) {
      assertTrue(line.codePoints().noneMatch(c -> Character.isISOControl(c) || Character.getType(c) == Character.FORMAT
          || c == 0x2028 || Character.getType(c) == Character.SURROGATE), line);
    }
    assertEquals("\\u001b[2J", Columns.safe("\u001b[2J"));
  }

  @Test
  void unusedPortsCanBeLeftOut() {
    PortStatus idle = new PortStatus(new SourceId("base", "/rosout"), PortKind.STREAM, "LogEntry", false, 0, 0,
        Double.NaN, false, 0, "", "");
    snapshot(connected(), List.of(idle), List.of());
    assertTrue(lines(80, 24).toString().contains("offered  base./rosout"));
    context.settings().set(TextType.UNUSED, false);
    assertFalse(lines(80, 24).toString().contains("/rosout"));
  }

  @Test
  void aTickWithoutNewsSaysSo() {
    assertTrue(view.tick(0));
    assertFalse(view.tick(1));
  }

  @Test
  void aFailedViewSaysWhy() {
    components(view("log", "text", "fenced: did not return within 2 s"));
    assertTrue(lines(80, 24).contains("  log (text)  failed: fenced: did not return within 2 s"),
        lines(80, 24).toString());
  }

  @Test
  void viewsThatNeedAWindowAreNamedInOneLineAndNotAsFailed() {
    components(
        view("map", "map", "type 'map' is not installed; installed are text"),
        view("front", "camera", "type 'camera' is not installed; installed are text"));
    assertEquals("not shown in a terminal, needs a window: map, front (camera)", lines(80, 24).getLast());
    assertFalse(lines(80, 24).toString().contains("failed"));
  }

  @Test
  void aViewWhoseBundleWentAwayHasFailed() {
    components(view("text2", "text", "type 'text' is not there; install or start bundle org.robotui.uic.text"));
    assertTrue(lines(90, 24).getLast().startsWith("  text2 (text)  failed: type 'text' is not there"),
        lines(90, 24).toString());
  }

  private void components(ComponentStatus... views) {
    RuicSnapshot now = context.ruic().snapshot();
    context.ruic().snapshot(
        new RuicSnapshot("Keira", RuicState.SELECTED, "", now.link(), List.of(views), List.of(), List.of()));
  }

  private static ComponentStatus view(String id, String type, String reason) {
    return new ComponentStatus(id, type, Kind.UIC, RuicState.FAILED, reason, Optional.empty());
  }

  private List<String> lines(int columns, int rows) {
    view.tick(0);
    return view.lines(columns, rows);
  }

  private void snapshot(LinkState link, List<PortStatus> ports, List<Match> matches) {
    context.ruic().snapshot(new RuicSnapshot("Keira", RuicState.SELECTED, "", link,
        List.of(new ComponentStatus("base", "ros", Kind.RFIC, RuicState.SELECTED, "", Optional.of(link))), ports,
        matches));
  }

  private static LinkState connected() {
    return new LinkState.Connected("localhost:11311");
  }

  private static PortStatus port(
      String name, String type, long count, double rate, double age, boolean stale, long dropped, String problem,
      String value) {
    return new PortStatus(
        new SourceId("base", name), PortKind.STREAM, type, true, count, rate, age, stale, dropped, problem, value);
  }

  private static Match match(MatchState state, String reason) {
    return new Match(new SourceId("camera", "image"), PortKind.STREAM, "Image", Arity.ONE, state, List.of(), List.of(),
        reason);
  }
}
