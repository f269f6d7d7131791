package org.robotui.rfic.yarp.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.Data;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.testkit.recorded.SharedData;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.port.PortArrival;
import org.robotui.yarp.wire.YarpFraming;

/** What real devices of YARP said, by the robot interface. */
@Timeout(120)
@EnabledIf(value = "org.robotui.rfic.yarp.internal.RecordedPorts#available", disabledReason = SharedData.REASON)
class RecordedYarpTest {
  private final List<String> asked = new CopyOnWriteArrayList<>();
  private final Map<String, Bottle> answers = new HashMap<>();
  private YarpRobot robot;

  @BeforeEach
  void begin() throws IOException {
    recordAnswers("b_board_rpc_i_tcp");
    robot = new YarpRobot();
    for (String name : List.of("/laser", "/imu/measures:o", "/board/state:o", "/board/stateExt:o", "/cam",
        "/bat/data:o", "/other:o")) {
      robot.says(name);
    }
    robot.says("/bat/rpc:i");
    robot.says("/laser/quit");
    robot.open("/board/rpc:i", this::answer);
    robot.look(Map.of());
  }

  @AfterEach
  void end() {
    if (robot != null) {
      robot.close();
    }
  }

  private void recordAnswers(String connection) throws IOException {
    List<Bottle> questions = RecordedPorts.bottles(connection);
    ByteArrayInputStream in = new ByteArrayInputStream(RecordedPorts.bytes(connection + ".s2c.bin"));
    YarpFraming.readMark(in);
    for (Bottle question : questions) {
      answers.put(question.toString(), BottleCodec.read(in));
      YarpFraming.readMark(in);
    }
  }

  /** As recorded where it was asked so, else by the recorded forms. */
  private Optional<Bottle> answer(PortArrival arrival) {
    String question = arrival.bottle().toString();
    asked.add(question);
    return Optional.of(answers.getOrDefault(question,
        Bottle.of(Bottle.vocabs(question.startsWith("[set]") ? "ok" : "fail"))));
  }

  @Test
  void a_scanner() throws IOException {
    LaserScan scan =
        robot.next("laser", LaserScan.class, "/laser", RecordedPorts.bottles("b_to_ui_laser_tcp").getFirst());
    assertEquals(360, scan.ranges().size());
    assertEquals(Math.toRadians(1), scan.angleIncrement(), 1e-12);
    assertEquals(0.7767214775085449, scan.ranges().get(0), 1e-6);
    assertEquals(8.0, scan.rangeMax());
  }

  @Test
  void an_inertial_unit() throws IOException {
    Imu imu =
        robot.next("imu/measures", Imu.class, "/imu/measures:o", RecordedPorts.bottles("b_to_ui_imu_tcp").getFirst());
    assertEquals(Math.toRadians(167), imu.angularVelocity().orElseThrow().x(), 1e-9);
    assertEquals(9.81, imu.linearAcceleration().orElseThrow().norm(), 1e-6);
    assertTrue(imu.orientation().isPresent());
  }

  @Test
  void a_camera_a_battery_and_anything_else() throws IOException {
    RawImage image = robot.next("cam", RawImage.class, "/cam", RecordedPorts.bottles("b_to_ui_cam_tcp").getFirst());
    assertEquals(PixelEncoding.RGB8, image.encoding());
    assertEquals("32 x 24", image.width() + " x " + image.height());
    Battery battery =
        robot.next("bat/data", Battery.class, "/bat/data:o", Bottle.of(24.5, 1.5, 80.0, 21.0, 2));
    assertEquals(new Battery(24.5, 1.5, 0.8, Battery.Status.DISCHARGING), battery);
    DynamicRecord other = robot.next("other", DynamicRecord.class, "/other:o", Bottle.of("far", 2.5));
    assertEquals(List.of("field1", "field2"), other.fields());
  }

  @Test
  void a_control_board_that_says_no_names() throws IOException {
    Bottle said = RecordedPorts.bottles("b_to_ui_read_tcp3").getLast();
    JointState joints = robot.next("board/stateExt", JointState.class, "/board/stateExt:o", said);
    assertEquals(List.of("board_0", "board_1", "board_2"), joints.joints().stream().map(j -> j.name()).toList());
    assertEquals(Math.toRadians(20), joints.joints().getFirst().position(), 1e-9);
    JointControl control = robot.next("board/control", JointControl.class, "/board/stateExt:o", said);
    assertEquals(Math.toRadians(200), control.joints().getFirst().measured().motorPosition(), 1e-9);
    assertEquals(Set.of(JointMode.POSITION), control.joints().get(0).modes());
    assertEquals(Set.of(JointMode.VELOCITY), control.joints().get(1).modes());
    robot.context.demand("board/model", true);
    robot.await("the limits", () -> !robot.context.published.get("board/model").isEmpty());
    JointModel model = (JointModel) robot.context.published.get("board/model").getLast().value();
    assertEquals(3, model.joints().size());
    assertTrue(!robot.context.streams.containsKey("board/state"), "state:o says nothing that stateExt:o does not");
  }

  @Test
  @SuppressWarnings("unchecked")
  void joints_are_driven_with_the_bytes_of_a_client() throws Exception {
    CommandSink<Data> sink = (CommandSink<Data>) robot.context.sinks.get("board/joints");
    assertInstanceOf(CommandSink.Sent.Refused.class, sink.send(positions(5)));
    robot.next("board/control", JointControl.class, "/board/stateExt:o",
        RecordedPorts.bottles("b_to_ui_stateExt_tcp").getFirst());
    asked.clear();
    assertEquals(new CommandSink.Sent.Unneeded(), sink.stop(JointCommand.ZERO, false));
    assertEquals(new CommandSink.Sent.Out(), sink.send(positions(5)));
    robot.await("it is told", () -> {
      sink.send(positions(5)); // again and again: one that is older than half a second is not told any more
      return asked.contains("[set] [pos] 1 5.0");
    });
    assertEquals(Set.of("[set] [pos] 1 5.0"), Set.copyOf(asked), "the joint is in its mode already");
    assertEquals(new CommandSink.Sent.Out(), sink.send(JointCommand.ZERO));
    robot.await("it is halted", () -> asked.contains("[set] [sto] 1"));
  }

  private static JointCommand positions(double degrees) {
    return new JointCommand(List.of(JointCommand.position("board_1", Math.toRadians(degrees))));
  }

  private ServiceReply call(String service, String command) throws CallException, InterruptedException {
    @SuppressWarnings("unchecked")
    CallHandler<ServiceRequest, ServiceReply> handler =
        (CallHandler<ServiceRequest, ServiceReply>) robot.context.handlers.get("services");
    return handler.handle(new Asking(new ServiceRequest(service, Map.of("command", command))));
  }

  /** A question that has a minute. */
  private record Asking(ServiceRequest request) implements CallHandler.Invocation<ServiceRequest> {
    @Override
    public long deadlineNanos() {
      return System.nanoTime() + Duration.ofMinutes(1).toNanos();
    }

    @Override
    public void progress(double fraction, String message) {
      // nothing says how far it is
    }

    @Override
    public void feedback(DynamicRecord record) {
      // nothing says anything before its answer
    }
  }

  @Test
  void ports_are_asked_and_listed() throws Exception {
    Browser browser = robot.context.browsers.get("graph");
    robot.await("the ports are listed", () -> lists(browser, Browser.Kind.SERVICE, "/board/rpc:i"));
    assertEquals(Optional.of(new FieldValue.Num(3, "3")), call("board/rpc:i", "[get] [axes]").value().field("field3"));
    CallException refused = assertThrows(CallException.class, () -> call("board/rpc:i", "[set] [pos] 0 10.0"));
    assertTrue(refused.getMessage().contains("drives the robot"), refused.getMessage());
    assertTrue(!asked.contains("[set] [pos] 0 10.0"));
    assertThrows(CallException.class, () -> call("laser", "[get] [axes]"));
    assertTrue(lists(browser, Browser.Kind.TOPIC, "/laser") && !lists(browser, Browser.Kind.TOPIC, "/laser/quit"));
    Browser.Item laser = browser.list(Browser.Kind.TOPIC).stream().filter(i -> i.name().equals("/laser")).findFirst()
        .orElseThrow();
    assertEquals("nobody", browser.describe(laser).facts().get("says to"));
  }

  private static boolean lists(Browser browser, Browser.Kind kind, String name) {
    try {
      return browser.list(kind).stream().anyMatch(item -> item.name().equals(name));
    } catch (CallException e) {
      throw new AssertionError(e);
    }
  }
}
