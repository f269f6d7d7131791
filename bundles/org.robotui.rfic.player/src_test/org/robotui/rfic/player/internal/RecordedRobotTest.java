package org.robotui.rfic.player.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.RawMessage;
import org.robotui.data.Data;
import org.robotui.data.image.RawImage;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.player.layout.InterfaceLayout;
import org.robotui.player.wire.MessageType;
import org.robotui.testkit.FakeRficContext;
import org.robotui.testkit.recorded.SharedData;

/** What real servers were recorded to say becomes data, all of it. */
@EnabledIf(value = "org.robotui.rfic.player.internal.RecordedRobot#available", disabledReason = SharedData.REASON)
@Timeout(300)
class RecordedRobotTest extends PlayerRficCase {
  private RecordedRobot robot;

  @AfterEach
  void closeRobot() throws IOException {
    robot.close();
  }

  static List<String> names() {
    return RecordedRobot.NAMES;
  }

  private void meet(String name) throws IOException {
    robot = new RecordedRobot(name, layouts, bytes -> bytes);
    start(Map.of("port", (long) robot.port()));
    await("the link is made", () -> link() instanceof LinkState.Connected);
    await("something is offered", () -> context.streams.size() > 1);
    List.copyOf(context.demands.keySet()).forEach(port -> context.demand(port, true));
  }

  /** The kinds of data that came of a device, by the names of their messages. */
  private Set<String> came(String device) {
    return context.published.entrySet().stream()
        .filter(e -> e.getKey().equals(device) || e.getKey().startsWith(device + "/"))
        .flatMap(e -> e.getValue().stream().map(FakeRficContext.Published::raw).flatMap(Optional::stream)
            .map(RawMessage::schema))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private Set<String> recorded(String device, List<Integer> numbers) {
    InterfaceLayout layout = layouts.byName(device.substring(0, device.indexOf(':'))).orElseThrow();
    return numbers.stream().map(n -> layout.name() + "/" + layout.message(MessageType.DATA, n).orElseThrow().name())
        .collect(Collectors.toCollection(TreeSet::new));
  }

  @ParameterizedTest
  @MethodSource("names")
  void allDataOfAllDevicesBecomeValues(String name) throws IOException {
    meet(name);
    robot.data().forEach((device, numbers) -> await(name + ": " + device + " says " + recorded(device, numbers),
        () -> came(device).equals(recorded(device, numbers))));
    robot.data().keySet().forEach(device -> context.complaints.forEach((port, complaints) -> {
      if (port.equals(device)) {
        assertEquals(List.of(), complaints.stream().filter(c -> !c.isEmpty() && !c.contains("get_")).toList(), port);
      }
    }));
  }

  private <D extends Data> D value(String port, Class<D> type) {
    return assertInstanceOf(type, first(port).value());
  }

  @Test
  void stagesRangersAreAScannerAndARing() throws IOException {
    meet("rangers");
    LaserScan scan = value("ranger:1/scan", LaserScan.class);
    assertEquals(180, scan.ranges().size());
    assertEquals(Float.POSITIVE_INFINITY, scan.ranges().get(0), "8 m is as far as it sees");
    assertEquals(1.48338f, scan.ranges().get(179), 1e-4);
    assertEquals(-Math.PI / 2, scan.angleMin(), 1e-3);
    RangeReadings ring = value("ranger:0/readings", RangeReadings.class);
    assertEquals(16, ring.readings().size());
    assertEquals(1.36775, ring.readings().getFirst().range(), 1e-4);
    assertEquals(0.2618, ring.readings().getFirst().fieldOfView(), 1e-3);
    assertEquals(180, value("laser:0", LaserScan.class).ranges().size());
    await("sensors are mounted",
        () -> context.transforms.stream().anyMatch(t -> t.child().name().equals("ranger_0_15")));
  }

  @Test
  void stagesBaseDrives() throws IOException {
    meet("position2d");
    await("it has driven 0.398 m", () -> context.published.get("position2d:0").stream().map(p -> (Odometry) p.value())
        .anyMatch(o -> Math.abs(o.pose().translation().x() - 0.398) < 1e-3 && o.linear().x() > 0.19));
    assertTrue(context.simulated.stream().anyMatch(nanos -> nanos > 0), "Stage's stamps are simulated time");
  }

  @Test
  void dummyDevicesSayWhatTheyAlwaysSay() throws IOException {
    meet("dummy_devices");
    GpsFix fix = value("gps:0", GpsFix.class);
    assertEquals(Math.toRadians(1), fix.latitude(), 1e-12);
    assertEquals(1, fix.altitude(), 1e-12);
    assertEquals(10, value("pointcloud3d:0", PointCloud.class).size());
    assertEquals(361, value("laser:0", LaserScan.class).ranges().size());
  }

  @Test
  void aRealCamerasPicturesAreShown() throws IOException {
    meet("dummy_camera");
    RawImage image = value("camera:0", RawImage.class);
    assertEquals(320, image.width());
    assertEquals(230_400, image.pixels().size());
  }

  @Test
  void aMapThatIsNoneIsToldWithWhatHelps() throws IOException {
    meet("simulation_map_properties");
    await("it is told", () -> context.complaints.get("map:0").stream().anyMatch(c -> c.contains("get_vector")));
    assertEquals(GridMap.class, context.streams.get("map:0").type());
  }

  @Test
  void whatTheServerRefusesIsTold() throws IOException {
    meet("errors");
    await("it is told in the link", () -> link() instanceof LinkState.Degraded d && d.reason().contains("gripper:0"));
    await("and at the port", () -> context.complaints.get("gripper:0").stream().anyMatch(c -> c.contains("gripper:0")));
  }
}
