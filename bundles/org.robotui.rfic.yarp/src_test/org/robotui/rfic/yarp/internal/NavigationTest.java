package org.robotui.rfic.yarp.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.port.CommandSink;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.port.PortArrival;

/** Navigation, localisation and maps with servers of our own, written after the sources of YARP 3.9.1 and 4.0. */
@Timeout(120)
class NavigationTest {
  private static final FrameId MAP = new FrameId("robby", "map");
  private static final RigidTransform THERE = RigidTransform.planar(2, -1, Math.PI / 2);

  private final List<String> asked = new CopyOnWriteArrayList<>();
  private final YarpRobot robot;
  private boolean newer;
  private volatile String status = "idle";
  private volatile boolean refuses;

  NavigationTest() throws IOException {
    robot = new YarpRobot();
    robot.open("/nav/navigation2D/rpc", this::navigate);
    robot.open("/loc/localization2D/rpc", this::localize);
    robot.open("/map2D_nws_yarp/rpc", this::map);
    robot.says("/base/rpc:i");
    robot.says("/base/data:i");
  }

  @AfterEach
  void end() {
    robot.close();
  }

  private static YarpValue vocab(String word) {
    return YarpValue.Vocab.of(word);
  }

  /** The list that YARP 4.0 begins an answer with that has more parts. */
  private Bottle answer(YarpValue... rest) {
    List<YarpValue> values = new ArrayList<>();
    values.add(newer && rest.length > 0 ? new Bottle(List.of(vocab("ok")), 0) : vocab("ok"));
    values.addAll(List.of(rest));
    return new Bottle(values, 0);
  }

  private Optional<Bottle> navigate(PortArrival arrival) {
    String question = arrival.bottle().toString();
    asked.add(question);
    if (question.startsWith("[get]")) {
      return Optional.of(answer(vocab(status)));
    }
    status = question.startsWith("[stop]") ? "idle" : "movg";
    return Optional.of(refuses ? new Bottle(List.of(vocab(newer ? "err5" : "fail")), 0) : answer());
  }

  private Optional<Bottle> localize(PortArrival arrival) {
    String question = arrival.bottle().toString();
    asked.add(question);
    return Optional.of(question.startsWith("[get]") ? answer(Bottle.of("hall", 1.5, 2.5, 90.0, "")) : answer());
  }

  /** Two columns and three rows; the cell at the lower left is occupied, the one at the upper right unknown. */
  private Optional<Bottle> map(PortArrival arrival) {
    String question = arrival.bottle().toString();
    asked.add(question);
    if (question.equals("[get] [map] names [RPC]")) {
      return Optional.of(answer(Bottle.of("cellar", "hall")));
    }
    byte[] cells = {0, (byte) 255, 0, 50, 100, 0};
    YarpValue.Blob packed = YarpValue.Blob.wrap(newer ? packed(cells) : cells);
    return Optional.of(answer(new Bottle(List.of(new YarpValue.Whole(2, 32), new YarpValue.Whole(3, 32),
        new YarpValue.Real(-1, 64), new YarpValue.Real(-2, 64), new YarpValue.Real(90, 64),
        new YarpValue.Real(0.5, 64), new YarpValue.Text("hall"), new YarpValue.Whole(newer ? 1 : 0, 8), packed, packed),
        0)));
  }

  private static byte[] packed(byte[] cells) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (DeflaterOutputStream packing = new DeflaterOutputStream(out)) {
      packing.write(cells);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
    return out.toByteArray();
  }

  private Data last(String port) {
    robot.await(port + " is offered", () -> robot.context.streams.containsKey(port));
    robot.context.demand(port, true);
    robot.await("one of " + port, () -> !robot.context.published.get(port).isEmpty());
    return robot.context.published.get(port).getLast().value();
  }

  /** How often a place was told that looks along y, but for what rounding leaves of the angle. */
  private long told(String begin) {
    return asked.stream().filter(each -> each.matches(Pattern.quote(begin) + "(90\\.0|89\\.9999\\d*) \"\"\\)"))
        .count();
  }

  private void awaitStatus(NavigationStatus.State state) {
    robot.await("it is " + state, () -> robot.context.published.get("nav/navigation2D/status").stream()
        .anyMatch(each -> ((NavigationStatus) each.value()).state() == state));
  }

  @SuppressWarnings("unchecked")
  private <D extends Data> CommandSink<D> sink(String port) {
    robot.await(port + " is offered", () -> robot.context.sinks.containsKey(port));
    return (CommandSink<D>) robot.context.sinks.get(port);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void a_goal_goes_on_its_way_and_is_stopped_with_the_robot(boolean newerForms) {
    newer = newerForms;
    robot.look(Map.of());
    CommandSink<NavigationGoal> goals = sink("nav/navigation2D/goal");
    robot.context.demand("nav/navigation2D/status", true);
    assertInstanceOf(CommandSink.Sent.Refused.class,
        goals.send(new NavigationGoal(new FrameId("robby", "odom"), THERE)));
    assertEquals(new CommandSink.Sent.Out(), goals.send(new NavigationGoal(MAP, THERE)));
    awaitStatus(NavigationStatus.State.ACTIVE);
    assertEquals(1, told("[goto] target [by] absolute location [RPC] (hall 2.0 -1.0 "), asked::toString);
    CommandSink<VelocityCommand> base = sink("base/velocity");
    base.stop(VelocityCommand.ZERO, false);
    robot.await("it is stopped", () -> asked.contains("[stop] navigation [RPC]"));
    awaitStatus(NavigationStatus.State.CANCELED);
    refuses = true;
    goals.send(new NavigationGoal(MAP, THERE));
    awaitStatus(NavigationStatus.State.REJECTED);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void the_robot_is_found_on_its_map(boolean newerForms) {
    newer = newerForms;
    robot.look(Map.of());
    PoseEstimate position = (PoseEstimate) last("loc/localization2D/position");
    assertEquals(new PoseEstimate(MAP, RigidTransform.planar(1.5, 2.5, Math.PI / 2), Doubles.EMPTY), position);
    GridMap map = (GridMap) last("map2D_nws_yarp/map");
    assertEquals("100,0,0,50,0,-1", cells(map));
    assertEquals(RigidTransform.planar(-1, -2, Math.PI / 2), map.origin());
    robot.await("the robot's map is fetched", () -> asked.contains("[get] [map] [RPC] hall"));
    CommandSink<PoseEstimate> places = sink("loc/localization2D/initial_pose");
    assertEquals(new CommandSink.Sent.Out(), places.send(position));
    robot.await("it is told", () -> told("[set] initial pose1 [RPC] (hall 1.5 2.5 ") == 1);
  }

  private static String cells(GridMap map) {
    List<String> cells = new ArrayList<>();
    for (int i = 0; i < map.cells().size(); i++) {
      cells.add(Byte.toString(map.cells().get(i)));
    }
    return String.join(",", cells);
  }
}
