package org.robotui.rfic.player.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.player.interfaces.Body;
import org.robotui.player.interfaces.Gripper;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Pose3d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Ranger;
import org.robotui.player.interfaces.Size3d;
import org.robotui.player.interfaces.Sonar;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.PlayerServer;
import org.robotui.player.server.ServedDevice;
import org.robotui.player.server.ServerOptions;
import org.robotui.testkit.FakeRficContext;

/** Streams, frames and records, against our own server. */
class PlayerRficTest extends PlayerRficCase {
  private static final Pose3d AHEAD = new Pose3d(0.1, 0, 0.2, 0, 0, 0);
  private static final Pose3d BEHIND = new Pose3d(-0.2, 0, 0, 0, 0, Math.PI);
  private static final Body BODY = new Body(AHEAD, new Size3d(0.4, 0.6, 0.3));
  private static final Position2d.State STATE =
      new Position2d.State(new Pose2d(1, 2, 0.5), new Pose2d(0.3, 0, -0.1), true);

  private ServedDevice position() {
    return add("position2d:0", handler("position2d:0").on(Position2d.GET_GEOMETRY, q -> Optional.of(BODY)));
  }

  private static double number(FakeRficContext.Published published, String path) {
    return ((FieldValue.Num) published.raw().orElseThrow().record().orElseThrow().at(FieldPath.parse(path))
        .orElseThrow()).value();
  }

  @Test
  void whatNobodyLooksAtIsNotOpened() {
    position();
    add("laser:0", handler("laser:0"));
    startConnected();
    await("both are offered",
        () -> context.streams.keySet().containsAll(Set.of("position2d:0", "position2d:0/footprint", "laser:0", "tf")));
    assertEquals(Odometry.class, context.streams.get("position2d:0").type());
    assertEquals(Set.of(), everOpened);
    context.demand("laser:0", true);
    await("the laser is opened, and what tells where it is",
        () -> everOpened.equals(Set.of("laser:0", "position2d:0")));
    context.demand("laser:0", false);
    await("both are closed", () -> clients.get("laser:0") == 0 && clients.get("position2d:0") == 0);
  }

  @Test
  void odometryMovesTheBase() {
    ServedDevice device = position();
    startConnected();
    want("position2d:0");
    device.publish(Position2d.STATE, STATE, STAMP);

    FakeRficContext.Published came = first("position2d:0");
    Odometry odometry = assertInstanceOf(Odometry.class, came.value());
    assertEquals(new FrameId("robby", "odom"), odometry.frame());
    assertEquals(new FrameId("robby", "base_link"), odometry.childFrame());
    assertEquals(2, odometry.pose().translation().y());
    assertEquals(0.3, odometry.linear().x());
    assertEquals(Optional.of(new Stamp(1_700_000_000_000_000_000L, ClockKind.ROBOT)), came.stamp());
    assertEquals(1, number(came, "position.x"));
    assertEquals("position2d/state", came.raw().orElseThrow().schema());
    await("the base is in the odometry",
        () -> context.transforms.stream().anyMatch(t -> t.child().name().equals("base_link")
            && t.parent().name().equals("odom") && t.parentFromChild().equals(odometry.pose()) && !t.fixed()));
    Footprint footprint = assertInstanceOf(Footprint.class, first("position2d:0/footprint").value());
    assertEquals(0.4, footprint.corners().getFirst().x(), 1e-9);
    assertEquals(0.2, footprint.corners().getFirst().y(), 1e-9);
  }

  @Test
  void aLaserIsMountedWhereItSays() {
    ServedDevice laser = add("laser:0", handler("laser:0").on(Laser.GET_GEOMETRY, q -> Optional.of(BODY)));
    startConnected();
    want("laser:0");
    await("the laser is mounted",
        () -> context.transforms.stream().anyMatch(t -> t.child().name().equals("laser_0") && t.fixed()
            && t.parent().name().equals("base_link") && t.parentFromChild().translation().x() == 0.1));
    laser.publish(Laser.SCAN, new Laser.Scan(-1, 1, 1, 8, new float[]{1, 8, 2}, new byte[]{1, 2, (byte) 200}, 5),
        STAMP);
    LaserScan scan = assertInstanceOf(LaserScan.class, first("laser:0").value());
    assertEquals(new FrameId("robby", "laser_0"), scan.frame());
    assertEquals(1, scan.angleIncrement());
    assertTrue(scan.isEcho(0));
    assertEquals(Float.POSITIVE_INFINITY, scan.ranges().get(1));
    assertEquals(200, scan.intensities().get(2));
  }

  @Test
  void aLaserThatDoesNotSayIsInTheMiddle() {
    add("laser:1", handler("laser:1"));
    startConnected();
    want("laser:1");
    await("the laser is mounted", () -> context.transforms.stream().anyMatch(t -> t.child().name().equals("laser_1")));
  }

  @Test
  void sonarsAreMountedOneByOne() {
    ServedDevice sonar = add("sonar:0",
        handler("sonar:0").on(Sonar.GET_GEOMETRY, q -> Optional.of(new Sonar.Geometry(List.of(AHEAD, BEHIND)))));
    startConnected();
    want("sonar:0");
    sonar.publish(Sonar.RANGES, new Sonar.Ranges(new float[]{1.5f, 6}), STAMP);
    RangeReadings readings = assertInstanceOf(RangeReadings.class, first("sonar:0").value());
    assertTrue(readings.readings().get(0).isEcho());
    assertFalse(readings.readings().get(1).isEcho());
    await("the sensors are mounted",
        () -> context.transforms.stream().anyMatch(t -> t.child().name().equals("sonar_0_1")
            && t.parentFromChild().translation().x() == -0.2));
  }

  @Test
  void aRangerIsAScannerOrARing() {
    Ranger.Config config = new Ranger.Config(-1, 1, 1, 0.1, 8, 0.01, 10);
    Size3d size = new Size3d(0.1, 0.1, 0.1);
    ServedDevice scanner = add("ranger:0", handler("ranger:0").on(Ranger.GET_CONFIG, q -> Optional.of(config))
        .on(Ranger.GET_GEOMETRY, q -> Optional.of(new Ranger.Geometry(AHEAD, size, List.of(AHEAD), List.of(size)))));
    ServedDevice ring = add("ranger:1", handler("ranger:1").on(Ranger.GET_CONFIG, q -> Optional.of(config))
        .on(Ranger.GET_GEOMETRY,
            q -> Optional.of(new Ranger.Geometry(AHEAD, size, List.of(AHEAD, BEHIND), List.of(size, size)))));
    startConnected();
    want("ranger:0/scan");
    want("ranger:1/readings");
    await("values come", () -> {
      scanner.publish(Ranger.RANGES, new Ranger.Ranges(new double[]{1, 2, 8}), STAMP);
      ring.publish(Ranger.RANGES, new Ranger.Ranges(new double[]{1, 2}), STAMP);
      return !context.published.get("ranger:0/scan").isEmpty() && !context.published.get("ranger:1/readings").isEmpty();
    });
    LaserScan scan = assertInstanceOf(LaserScan.class, first("ranger:0/scan").value());
    assertEquals(0.1, scan.rangeMin());
    assertEquals(0.1, scan.scanTime());
    assertEquals(2, ((RangeReadings) first("ranger:1/readings").value()).readings().size());
    assertFalse(context.streams.containsKey("ranger:0/readings"));
    assertFalse(context.streams.containsKey("ranger:1/scan"));
    await("the sensors of a ring stand on the device", () -> context.transforms.stream().anyMatch(
        t -> t.child().name().equals("ranger_1_0") && Math.abs(t.parentFromChild().translation().x() - 0.2) < 1e-9));
  }

  @Test
  void whatNothingIsMadeOfIsARecord() {
    ServedDevice gripper = add("gripper:0", handler("gripper:0"));
    startConnected();
    want("gripper:0");
    assertEquals(DynamicRecord.class, context.streams.get("gripper:0").type());
    gripper.publish(Gripper.STATE, new Gripper.State(2, 3, 1), STAMP);
    DynamicRecord record = assertInstanceOf(DynamicRecord.class, first("gripper:0").value());
    assertEquals("gripper/state", record.schema());
    assertEquals(List.of("state", "beams", "stored"), record.fields());
    assertEquals(Optional.of(new FieldValue.Num(3, "3")), record.field("beams"));
  }

  @Test
  void anInterfaceThatNobodyKnowsIsBytes() throws IOException {
    server.close();
    Layouts more = layouts.with("odour", "interface 999 odour\ndata 3 state state\nstruct state\n  u32 smell\n");
    server = new PlayerServer(more, ServerOptions.loopback(DAEMONS, 0, () -> STAMP));
    ServedDevice nose = server.add("odour", 2, "nose", handler("interface999:2"));
    startConnected();
    want("interface999:2");
    nose.publish(3, ByteBuffer.wrap(new byte[]{0, 0, 1, 2}), STAMP);
    DynamicRecord record = assertInstanceOf(DynamicRecord.class, first("interface999:2").value());
    assertEquals("interface999/3", record.schema());
    assertEquals(Optional.of(new FieldValue.Numbers(Doubles.of(0, 0, 1, 2))), record.field("bytes"));
  }

  @Test
  void damagedDataAreCountedAndTheLinkStays() {
    ServedDevice laser = add("laser:0", handler("laser:0"));
    startConnected();
    want("laser:0");
    laser.publish(1, ByteBuffer.wrap(new byte[]{1, 2, 3}), STAMP);
    await("the mistake is told", () -> context.complaints.get("laser:0").stream()
        .anyMatch(c -> c.contains("laser:0") && c.contains("127.0.0.1")));
    laser.publish(Laser.SCAN, new Laser.Scan(Float.NaN, 1, 1, 8, new float[]{1, 8, 2}, new byte[0], 5), STAMP);
    await("values that are none are told",
        () -> context.complaints.get("laser:0").stream().anyMatch(c -> c.contains("angle")));
    laser.publish(77, ByteBuffer.wrap(new byte[]{1, 2, 3, 4}), STAMP);
    await("data that are not known are told",
        () -> context.complaints.get("laser:0").stream().anyMatch(c -> c.contains("data 77")));
    assertInstanceOf(LinkState.Connected.class, link());
  }

  @Test
  void onlyChosenDevicesAreUsed() {
    position();
    add("laser:0", handler("laser:0"));
    add("laser:1", handler("laser:1"));
    start(Map.of("devices", List.of("laser:1", "pos*")));
    await("they are offered", () -> context.streams.keySet().containsAll(Set.of("position2d:0", "laser:1")));
    assertFalse(context.streams.containsKey("laser:0"));
  }

  @Test
  void stampsOfASimulationAreItsTime() {
    ServedDevice device = position();
    startConnected();
    want("position2d:0");
    device.publish(Position2d.STATE, STATE, 12.25);
    assertEquals(Optional.of(new Stamp(12_250_000_000L, ClockKind.SIMULATED)), first("position2d:0").stamp());
    assertEquals(12_250_000_000L, context.simulated.getLast());
  }
}
