package org.robotui.uic.status.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.data.sensor.Battery;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;

class StatusViewStateTest {
  private static final SourceId POWER = new SourceId("base", "/battery");

  @Test
  void everyPortHasADotAndAWord() {
    assertItem("/scan", Health.OK, "10.0\u00a0Hz");
    assertItem("/amcl_pose", Health.STALE, "stale");
    assertItem("/map", Health.WAITING, "waiting");
    assertItem("/diagnostics", Health.BAD, "failed");
    assertItem("/rosout", Health.NONE, "offered");
    assertItem("/cmd_vel", Health.OK, "20.0\u00a0Hz");
  }

  @Test
  void agesAndDropsAreShownWhereThereAreAny() {
    assertEquals("71\u00a0ms", item("/sonar").age());
    assertEquals("14 dropped", item("/sonar").dropped());
    assertEquals("", item("/map").age());
    assertEquals("", item("/scan").dropped());
  }

  @Test
  void aFailedPortSaysWhyInPlaceOfAValue() {
    assertEquals("10.0.0.7:45123 sends foo/Diag, expected diagnostic_msgs/DiagnosticArray",
        item("/diagnostics").value());
  }

  @Test
  void linksComeFirstAndSayWhenTheyAreTriedAgain() {
    RuicSnapshot lost = Snapshots.of(
        new LinkState.Failed("localhost:11311 refuses the connection", Duration.ofSeconds(4)), List.of(), List.of());
    StatusRow.Item link = assertInstanceOf(StatusRow.Item.class, look(lost, false).rows("").getFirst());
    assertEquals(Health.BAD, link.health());
    assertEquals("retry 4 s", link.word());
    assertEquals("localhost:11311 refuses the connection", link.value());
  }

  @Test
  void whatAViewLacksIsASentenceButWhatIsOptionalIsNot() {
    List<String> notes = look(Snapshots.typical(), false).rows("").stream()
        .filter(StatusRow.Note.class::isInstance).map(StatusRow::details).toList();
    assertEquals(List.of(
        "camera.image: two ports fit; choose one of base./camera/image_raw and natalie./image in the camera view"),
        notes);
  }

  @Test
  void portsThatNoViewUsesStandBelowAHeading() {
    List<StatusRow> rows = look(Snapshots.typical(), false).rows("");
    int head = rows.indexOf(rows.stream().filter(StatusRow.Head.class::isInstance).findFirst().orElseThrow());
    assertEquals("/imu/data", ((StatusRow.Item) rows.get(head + 1)).name());
  }

  @Test
  void logsStandApartFromWhatIsMeasuredUsedOrNot() {
    List<PortStatus> ports = List.of(
        Snapshots.port("/rosout", "LogEntry", false, 0, Double.NaN, false, 0, ""),
        Snapshots.port("/rosout_agg", "LogEntry", true, 3, 0.2, false, 0, "info"),
        Snapshots.port("/scan", "LaserScan", true, 10, 0.02, false, 0, ""));
    List<StatusRow> rows = look(Snapshots.of(Snapshots.UP, ports, List.of()), false).rows("");
    assertEquals(List.of("/scan", "LOGS OF THE ROBOT'S PROGRAMS", "/rosout", "/rosout_agg"),
        rows.subList(1, rows.size()).stream().map(row -> row instanceof StatusRow.Item item ? item.name() : row.key())
            .toList());
  }

  @Test
  void onlyWhatFlowsIsCountedAsInUse() {
    List<PortStatus> ports = List.of(
        Snapshots.port("/scan", "LaserScan", true, 10, 0.02, false, 0, ""),
        Snapshots.port("/imu", "Imu", false, 0, Double.NaN, false, 0, ""),
        new PortStatus(POWER, PortKind.COMMAND, "VelocityCommand", true, 1, 1, 1, false, 0, "", ""),
        new PortStatus(POWER, PortKind.CALL, "ServiceRequest -> ServiceReply", true, 0, 0, Double.NaN, false, 0, "",
            ""),
        new PortStatus(POWER, PortKind.BROWSE, "Browser", true, 0, 0, Double.NaN, false, 0, "", ""));
    assertEquals("link connected \u00b7 2 of 3 ports in use",
        look(Snapshots.of(Snapshots.UP, ports, List.of()), false).note());
  }

  @Test
  void theFilterLooksAtNameTypeAndValue() {
    assertEquals(List.of("/sonar"), names("rangeREADINGS"));
    assertEquals(List.of("/scan"), names("min 0.42"));
    assertEquals(List.of(), names("nowhere"));
  }

  @Test
  void connectionsAreListedWithTheirReasons() {
    List<StatusRow> rows = look(Snapshots.typical(), true).rows("");
    StatusRow.Item ambiguous = (StatusRow.Item) rows.get(0);
    assertEquals("ambiguous", ambiguous.word());
    assertTrue(ambiguous.value().startsWith("two ports fit"));
    assertEquals("base./scan", ((StatusRow.Item) rows.get(2)).value());
    assertEquals(Health.NONE, ((StatusRow.Item) rows.get(1)).health(), "what is optional and absent is no fault");
  }

  @Test
  void theRowsStayInOrderWhileValuesChange() {
    List<Object> before = look(Snapshots.typical(), false).rows("").stream().map(StatusRow::key).toList();
    assertEquals(before, look(Snapshots.typical(), false).rows("").stream().map(StatusRow::key).toList());
    assertEquals(before.size(), before.stream().distinct().count());
  }

  @Test
  void aBatteryHasABarAndTurnsFromGoodToWarningToFault() {
    assertEquals(Health.OK, charge(0.87).health());
    assertEquals("87\u00a0%  14.1\u00a0V  \u22121.2\u00a0A", charge(0.87).texts().getFirst());
    assertEquals(Health.WARNING, charge(0.2).health());
    assertEquals(Health.BAD, charge(0.1).health());
    assertEquals(Health.OK, charge(Double.NaN).health(), "an unknown charge is no fault");
    assertEquals("14.1\u00a0V  \u22121.2\u00a0A", charge(Double.NaN).texts().getFirst());
  }

  @Test
  void aSilentBatteryIsWaitingOrStale() {
    StatusRow.Charge none = (StatusRow.Charge) BatteryRows.of(POWER, "Battery", Optional.empty(),
        new InputState.Waiting("no value yet"), 0.25);
    assertEquals("waiting", none.texts().getFirst());
    StatusRow.Charge old = (StatusRow.Charge) BatteryRows.of(POWER, "Battery",
        Optional.of(new Battery(14.1, Double.NaN, 0.87, Battery.Status.CHARGING)), new InputState.Stale(9, "silent"),
        0.25);
    assertEquals(Health.STALE, old.health());
    assertEquals("stale 9.0\u00a0s  87\u00a0%  14.1\u00a0V  charging", old.texts().getFirst());
    assertEquals(List.of("stale 9.0\u00a0s  87\u00a0%  charging", "stale 9.0\u00a0s  87\u00a0%"),
        old.texts().subList(1, 3), "where there is little room");
  }

  @Test
  void emptyAndFailedSayWhatWouldHelp() {
    FakeUicContext context = new FakeUicContext("status", new StatusType().schema());
    assertEquals(Health.NONE, look(context.ruic().snapshot(), false).trouble().orElseThrow().health());
    RuicSnapshot failed = new RuicSnapshot("Keira", RuicState.FAILED, "the type 'ros' is not installed", Snapshots.UP,
        List.of(), List.of(), List.of());
    assertEquals("the type 'ros' is not installed", look(failed, false).trouble().orElseThrow().sentence());
    assertEquals(Optional.empty(), look(Snapshots.typical(), false).trouble());
  }

  @Test
  void theTickTellsNewsAndTheStopIsLatched() {
    FakeUicContext context = new FakeUicContext("status", new StatusType().schema());
    StatusUic uic = new StatusUic(context);
    assertFalse(uic.tick(0));
    context.input(StatusType.BATTERY).put(new Battery(12, -1, 0.5, Battery.Status.DISCHARGING));
    assertTrue(uic.tick(1));
    StatusUic.Actions actions = uic.new Actions();
    actions.stop();
    assertEquals(Optional.of(FakeAuthority.YOU), context.authority().stoppedBy());
    actions.releaseStop();
    assertEquals(Optional.empty(), context.authority().stoppedBy());
  }

  @Test
  void aFilterCountsFromTheNextTickOn() {
    FakeUicContext context = new FakeUicContext("status", new StatusType().schema());
    context.ruic().snapshot(Snapshots.typical());
    StatusUic uic = new StatusUic(context);
    StatusUic.Actions actions = uic.new Actions();
    int all = uic.page().rows().size();
    actions.filter("sonar");
    assertTrue(uic.tick(0));
    assertTrue(uic.page().rows().size() < all);
    actions.filter("");
    assertTrue(uic.tick(1));
    assertEquals(all, uic.page().rows().size());
    assertFalse(uic.tick(2), "nothing new");
  }

  private static StatusRow.Charge charge(double share) {
    return (StatusRow.Charge) BatteryRows.of(
        POWER, "Battery", Optional.of(new Battery(14.1, -1.2, share, Battery.Status.DISCHARGING)),
        new InputState.Live(1, 0.2), 0.25);
  }

  private static void assertItem(String name, Health health, String word) {
    assertEquals(health, item(name).health(), name);
    assertEquals(word, item(name).word(), name);
  }

  private static StatusRow.Item item(String name) {
    return look(Snapshots.typical(), false).rows("").stream()
        .filter(StatusRow.Item.class::isInstance).map(StatusRow.Item.class::cast)
        .filter(row -> row.name().equals(name)).findFirst().orElseThrow();
  }

  private static List<String> names(String filter) {
    return look(Snapshots.typical(), false).rows(filter).stream()
        .filter(StatusRow.Item.class::isInstance).map(row -> ((StatusRow.Item) row).name()).toList();
  }

  private static StatusViewState look(RuicSnapshot snapshot, boolean connections) {
    return new StatusViewState(snapshot, List.of(), Optional.empty(), connections);
  }
}
