package org.robotui.rfic.carmen.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.api.Rfic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CommandSink;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForms;
import org.robotui.data.Data;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.guard.Guards;
import org.robotui.testkit.FakeRficContext;

/** What a real central and real programs said, by the robot interface. */
@Timeout(120)
class RecordedCarmenTest {
  private final FakeRficContext context = new FakeRficContext();
  private RecordedCentral central;
  private Rfic rfic;

  private void start(String session, String... modules) throws IOException {
    central = new RecordedCentral(session, List.of(modules));
    rfic = CarmenSessions.rfic(context,
        CarmenPeer.settings(Map.of("host", "127.0.0.1", "port", (long) central.port())), new Guards());
    rfic.start();
    await("the link is made", () -> context.links.stream().anyMatch(LinkState.Connected.class::isInstance));
  }

  @AfterEach
  void end() throws IOException {
    if (rfic != null) {
      rfic.close();
      central.close();
      assertEquals(List.of(), central.complaints());
    }
  }

  private void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + Duration.ofSeconds(30).toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, () -> what + "; " + context.links + " " + context.streams.keySet());
      try {
        Thread.sleep(10);
      } catch (InterruptedException e) {
        throw new AssertionError(e);
      }
    }
  }

  private <D extends Data> List<D> all(String port, Class<D> type, int count) {
    await(port + " is offered", () -> context.streams.containsKey(port));
    context.demand(port, true);
    await(count + " of " + port,
        () -> Optional.ofNullable(context.published.get(port)).map(d -> d.size()).orElse(0) >= count);
    return context.published.get(port).stream().map(p -> type.cast(p.value())).toList();
  }

  @Test
  void a_base_with_a_scanner() throws IOException {
    start("base", "simulator", "robot", "client");
    Odometry last = all("base_odometry", Odometry.class, 20).getLast();
    assertEquals("odom", last.frame().name());
    LaserScan scan = all("robot_frontlaser", LaserScan.class, 20).getFirst();
    assertEquals(181, scan.ranges().size());
    assertEquals(-Math.PI / 2, scan.angleMin(), 1e-9);
    PoseEstimate truth = all("simulator_truepos", PoseEstimate.class, 20).get(10);
    assertEquals(8.4, truth.pose().translation().y(), 0.01);
    assertTrue(context.published.get("base_odometry").stream().allMatch(p -> p.stamp().isPresent()));
  }

  @Test
  void a_robot_that_knows_where_it_is() throws IOException {
    start("localize", "simulator", "robot", "localize", "logger", "client");
    RangeReadings sonars = all("base_sonar", RangeReadings.class, 5).getFirst();
    assertEquals(7, sonars.readings().size());
    assertEquals(0.5236, sonars.readings().getFirst().fieldOfView(), 1e-4);
    PoseEstimate place = all("localize_globalpos", PoseEstimate.class, 5).getLast();
    assertEquals(30, place.pose().translation().x(), 1);
    assertEquals("map", place.frame().name());
  }

  @Test
  void the_map_is_asked_for_when_somebody_looks() throws IOException {
    start("localize", "simulator", "robot", "map", "localize", "client");
    GridMap map = all("grid_map_message", GridMap.class, 1).getFirst();
    assertTrue(map.width() > 100 && map.height() > 100, () -> map.width() + " x " + map.height());
    // the robot stands in the free at 30.0, 8.4
    int column = (int) (30.0 / map.resolution());
    int row = (int) (8.4 / map.resolution());
    assertTrue(map.cells().get(row * map.width() + column) < 30, "the robot stands on a free cell");
  }

  @Test
  @SuppressWarnings("unchecked")
  void what_is_driven_has_the_bytes_of_a_real_client() throws Exception {
    start("base", "simulator", "robot", "client");
    await("it can be driven", () -> context.sinks.containsKey("velocity"));
    ((CommandSink<Data>) context.sinks.get("velocity")).send(VelocityCommand.planar(0.2, 0.1));
    await("it is heard", () -> central.heard("carmen_robot_vel").isPresent());
    IpcRecord said = IpcForms.carmen().get("carmen_robot_vel")
        .read(central.heard("carmen_robot_vel").orElseThrow().body());
    assertEquals(0.2, said.number("tv"));
    assertEquals(0.1, said.number("rv"));
  }

  @Test
  void parameters_are_read() throws Exception {
    start("base", "simulator", "robot", "client");
    Browser browser = context.browsers.get("graph");
    assertTrue(browser.list(Browser.Kind.TOPIC).stream().anyMatch(i -> i.name().equals("carmen_base_odometry")));
    assertEquals(Optional.empty(), browser.parameter("robot/no_such"));
  }
}
