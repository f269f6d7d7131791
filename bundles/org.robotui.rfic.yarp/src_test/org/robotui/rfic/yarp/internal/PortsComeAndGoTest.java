package org.robotui.rfic.yarp.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.api.link.LinkState;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.sensor.LaserScan;
import org.robotui.net.socket.HostPort;
import org.robotui.yarp.bottle.Bottle;

/** Name server, ports and workbench, which come and go in every order. */
@Timeout(180)
class PortsComeAndGoTest {
  private static final Bottle SCAN = Bottle.of(0.0, 90.0, 0.1, 8.0, List.of(1.0, 2.0), 1);

  private final YarpRobot robot;

  PortsComeAndGoTest() throws IOException {
    robot = new YarpRobot();
    robot.says("/robby/laser");
  }

  @AfterEach
  void end() {
    robot.close();
  }

  private void sees() {
    robot.next("laser", LaserScan.class, "/robby/laser", SCAN);
  }

  @Test
  void a_port_that_comes_back_elsewhere_is_told_again() throws IOException {
    robot.look(Map.of("prefix", "/robby"));
    sees();
    robot.end("/robby/laser");
    robot.await("that is told", () -> robot.context.links.peekLast() instanceof LinkState.Degraded);
    assertTrue(robot.context.links.peekLast().reason().contains("does not answer"),
        robot.context.links.peekLast()::toString);
    robot.says("/robby/laser");
    sees();
    robot.await("it is connected", () -> robot.context.links.peekLast() instanceof LinkState.Connected);
  }

  @Test
  void a_name_server_that_was_started_anew_is_told_of_our_port() throws IOException {
    robot.look(Map.of("prefix", "/robby"));
    sees();
    List<String> before = robot.registered();
    assertEquals(1, before.size());
    robot.endServer();
    robot.await("that is told", () -> robot.context.links.peekLast() instanceof LinkState.Degraded);
    sees();
    robot.restartServer();
    robot.await("it is registered again", () -> robot.registered().equals(before));
    sees();
  }

  @Test
  void what_a_killed_workbench_left_is_tidied_and_what_runs_is_not() throws IOException {
    robot.server().register("/robotui/killed/1-base", new HostPort("127.0.0.1", 1));
    robot.server().register("/robotui/other/2-base", new HostPort("127.0.0.1", robot.server().port()));
    robot.look(Map.of("prefix", "/robby"));
    robot.await("what is left is tidied", () -> !robot.registered().contains("/robotui/killed/1-base"));
    assertTrue(robot.registered().contains("/robotui/other/2-base"));
  }

  @Test
  void ports_that_come_later_are_found_and_users_say_what_they_are() throws IOException {
    robot.look(Map.of("prefix", "/robby", "types", Map.of("/robby/front:o", "laser", "/robby/laser", "record")));
    robot.says("/robby/front:o");
    robot.says("/elsewhere/laser");
    robot.next("front", LaserScan.class, "/robby/front:o", SCAN);
    robot.next("laser", DynamicRecord.class, "/robby/laser", SCAN);
    assertTrue(robot.context.streams.keySet().stream().noneMatch(name -> name.contains("elsewhere")));
  }
}
