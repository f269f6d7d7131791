package org.robotui.rfic.player.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedDeque;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Browser;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.player.interfaces.Actarray;
import org.robotui.player.interfaces.Gripper;
import org.robotui.player.interfaces.Localize;
import org.robotui.player.interfaces.Planner;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Position3d;
import org.robotui.player.interfaces.Speech;
import org.robotui.player.layout.Empty;
import org.robotui.player.server.ServedDevice;

/** What goes to the devices of our own server. */
class PlayerCommandsTest extends PlayerRficCase {
  private static final FrameId MAP = new FrameId("robby", "map");

  private final Deque<Object> heard = new ConcurrentLinkedDeque<>();

  private void base() {
    add("position2d:0", handler("position2d:0").on(Position2d.VELOCITY, heard::add).on(Position2d.MOTOR_POWER, q -> {
      heard.add(q);
      return Optional.of(new Empty());
    }));
  }

  /** As views do: what is refused while the device is being opened is said again. */
  private void sendUntilOut(String port, org.robotui.data.Data command) {
    await(port + " is offered", () -> context.sinks.containsKey(port));
    await(port + " takes it", () -> send(port, command) instanceof Sent.Out);
  }

  @Test
  void velocitiesOpenTheBaseAndZeroEndsThemOnClosing() {
    base();
    startConnected();
    await("it is offered", () -> context.commands.containsKey("position2d:0/velocity"));
    assertEquals(Set.of(), everOpened);
    sendUntilOut("position2d:0/velocity", VelocityCommand.planar(0.3, 0.1));
    await("the base heard it", () -> heard.contains(new Position2d.Velocity(new Pose2d(0.3, 0, 0.1), true)));

    rfic.close();
    await("zero is the last", () -> heard.getLast().equals(new Position2d.Velocity(new Pose2d(0, 0, 0), true)));
    await("it is closed", () -> clients.get("position2d:0") == 0);
    assertTrue(heard.stream().allMatch(Position2d.Velocity.class::isInstance), "motor power was never touched");
  }

  @Test
  void whatOthersDriveIsLeftAlone() {
    base();
    startConnected();
    want("position2d:0");
    sendUntilOut("position2d:0/velocity", VelocityCommand.planar(0.3, 0));
    await("the base heard it", () -> heard.size() == 1); // what waits for the network is replaced by what is newer
    sendUntilOut("position2d:0/velocity", VelocityCommand.ZERO);
    await("zero came", () -> heard.size() == 2);
    int before = heard.size();
    rfic.close();
    await("it is closed", () -> clients.get("position2d:0") == 0);
    assertEquals(before, heard.size(), "nothing is stopped that we do not drive");
  }

  private static final Position2d.Velocity STAND = new Position2d.Velocity(new Pose2d(0, 0, 0), true);

  @Test
  void aStopReachesTheBaseThatOthersDriveAndOpensNothing() {
    base();
    add("position2d:1", handler("position2d:1").on(Position2d.VELOCITY, v -> heard.add("position2d:1")));
    add("position3d:0", handler("position3d:0").on(Position3d.VELOCITY, v -> heard.add("position3d:0")));
    startConnected();
    await("all are offered", () -> context.sinks.keySet()
        .containsAll(Set.of("position2d:0/velocity", "position2d:1/velocity", "position3d:0/velocity")));
    assertEquals(new Sent.Unneeded(), stop("position3d:0/velocity", VelocityCommand.ZERO, false));
    assertEquals(new Sent.Unneeded(), stop("position2d:1/velocity", VelocityCommand.ZERO, false));
    assertEquals(new Sent.Out(), stop("position2d:0/velocity", VelocityCommand.ZERO, false));
    await("the base heard it", () -> heard.contains(STAND));
    assertEquals(List.of(STAND), List.copyOf(heard), "nobody drove the others from here");
    assertEquals(Set.of(), everOpened);
  }

  @Test
  void aStopWhereWeDroveIsNotRefusedWhileTheDeviceIsBeingOpened() {
    base();
    startConnected();
    await("it is offered", () -> context.sinks.containsKey("position2d:0/velocity"));
    assertEquals(new Sent.Out(), stop("position2d:0/velocity", VelocityCommand.ZERO, true));
    await("the base heard it", () -> heard.contains(STAND));
    await("it is opened, as what it does is of interest", () -> everOpened.contains("position2d:0"));
  }

  @Test
  void aZeroForWhatNobodyDrivesFromHereOpensNothing() {
    base();
    add("position3d:0", handler("position3d:0").on(Position3d.VELOCITY, v -> heard.add("position3d:0")));
    startConnected();
    await("it is offered", () -> context.sinks.containsKey("position3d:0/velocity"));
    send("position3d:0/velocity", VelocityCommand.ZERO);
    send("position2d:0/velocity", VelocityCommand.ZERO);
    await("the base heard it", () -> heard.contains(STAND));
    assertEquals(List.of(STAND), List.copyOf(heard));
    assertEquals(Set.of(), everOpened);
  }

  @Test
  void vehiclesInSpaceTakeAllSixAxes() {
    add("position3d:0", handler("position3d:0").on(Position3d.VELOCITY, heard::add));
    startConnected();
    sendUntilOut("position3d:0/velocity", new VelocityCommand(new Vector3(1, 2, 3), new Vector3(4, 5, 6)));
    await("it came", () -> !heard.isEmpty());
    assertEquals(6, ((Position3d.Velocity) heard.getFirst()).velocity().yaw());
  }

  private static JointCommand.Joint velocity(String joint, double speed) {
    return new JointCommand.Joint(joint, new JointControl.Reference(0, speed, 0, 0, 0), Set.of(JointMode.VELOCITY));
  }

  @Test
  void armsAreMovedAndHalted() {
    ServedDevice arm = add("actarray:0",
        handler("actarray:0").on(Actarray.POSITIONS, p -> heard.add(Doubles.of(p.positions()[0], p.positions()[1])))
            .on(Actarray.SPEEDS, s -> heard.add(s.speeds()[1])));
    startConnected();
    want("actarray:0");
    arm.publish(Actarray.STATE,
        new Actarray.State(List.of(new Actarray.Actuator(0.5f, 0, 0, 0, 1), new Actarray.Actuator(1.5f, 0, 0, 0, 1)),
            true),
        STAMP);
    first("actarray:0/control");
    sendUntilOut("actarray:0/joints", JointCommand.ZERO); // unneeded until the interface knows that it is open
    sendUntilOut("actarray:0/joints", new JointCommand(List.of(JointCommand.position("actarray_0_0", 0.25))));
    await("the other joint stays", () -> heard.contains(Doubles.of(0.25, 1.5)));
    sendUntilOut("actarray:0/joints", JointCommand.ZERO);
    await("it stays where it is", () -> heard.contains(Doubles.of(0.5, 1.5)));
    assertEquals(2, heard.size(), "what we did not move was left alone before");
    sendUntilOut("actarray:0/joints", new JointCommand(List.of(velocity("actarray_0_1", 0.5))));
    await("it moves", () -> heard.contains(0.5f));
    rfic.close();
    await("it is halted on closing", () -> heard.getLast().equals(0f));
  }

  @Test
  void whatAnArmCannotDoIsRefused() {
    ServedDevice arm = add("actarray:0", handler("actarray:0"));
    startConnected();
    want("actarray:0");
    arm.publish(Actarray.STATE, new Actarray.State(List.of(new Actarray.Actuator(0.5f, 0, 0, 0, 1)), true), STAMP);
    first("actarray:0");
    JointCommand unknown = new JointCommand(List.of(JointCommand.position("elbow", 0)));
    assertTrue(((Sent.Refused) send("actarray:0/joints", unknown)).reason().contains("elbow"));
    JointCommand mixed =
        new JointCommand(List.of(JointCommand.position("actarray_0_0", 0), velocity("actarray_0_0", 1)));
    assertTrue(((Sent.Refused) send("actarray:0/joints", mixed)).reason().contains("positions or by velocities"));
  }

  @Test
  void goalsAndPosesAreOnTheMap() {
    add("planner:0", handler("planner:0").on(Planner.GOAL, heard::add));
    add("localize:0", handler("localize:0").on(Localize.SET_POSE, q -> {
      heard.add(q);
      return Optional.of(new Empty());
    }));
    startConnected();
    RigidTransform place = RigidTransform.planar(1, 2, 0.5);
    sendUntilOut("planner:0/goal", new NavigationGoal(MAP, place));
    await("the goal came", () -> heard.stream().anyMatch(h -> h instanceof Planner.Place p && p.pose().y() == 2));
    double[] covariance = new double[36];
    covariance[0] = 0.25;
    covariance[35] = 0.1;
    sendUntilOut("localize:0/initial_pose", new PoseEstimate(MAP, place, Doubles.wrap(covariance)));
    await("the pose came",
        () -> heard.stream().anyMatch(h -> h instanceof Localize.Estimate e && e.covariance()[0] == 0.25
            && e.covariance()[2] == 0.1));
    Sent elsewhere = send("planner:0/goal", new NavigationGoal(new FrameId("robby", "odom"), place));
    assertTrue(((Sent.Refused) elsewhere).reason().contains("map"), elsewhere.toString());
  }

  @Test
  void aPoseThatIsRefusedIsTold() {
    add("localize:0", handler("localize:0").on(Localize.SET_POSE, q -> Optional.empty()));
    startConnected();
    sendUntilOut("localize:0/initial_pose", new PoseEstimate(MAP, RigidTransform.IDENTITY, Doubles.EMPTY));
    await("the refusal is told",
        () -> context.complaints.get("localize:0").stream().anyMatch(c -> c.contains("localize:0")));
  }

  @Test
  void callsAskAndTell() throws CallException {
    base();
    add("gripper:0", handler("gripper:0").on(Gripper.OPEN, heard::add));
    add("speech:0", handler("speech:0").on(Speech.SAY, heard::add));
    startConnected();
    await("they are known",
        () -> context.streams.containsKey("gripper:0") && context.streams.containsKey("position2d:0"));
    call("position2d:0/motor_power", Map.of("on", true));
    call("gripper:0/open", Map.of());
    call("speech:0/say", Map.of("text", "good morning"));
    await("all came", () -> heard.size() == 3);
    assertTrue(heard.contains(new Speech.Text("good morning")));

    CallException refused = assertThrows(CallException.class, () -> call("position2d:0/reset_odometry", Map.of()));
    assertTrue(refused.getMessage().contains("position2d:0"), refused.getMessage());
    assertTrue(assertThrows(CallException.class, () -> call("position2d:0/motor_power", Map.of("off", 1L))).getMessage()
        .contains("off"));
    assertThrows(CallException.class, () -> call("position2d:0/motor_power", Map.of("on", "maybe")));
    assertThrows(CallException.class, () -> call("position2d:0/velocity", Map.of()),
        "driving is for ports with limits");
    assertTrue(assertThrows(CallException.class, () -> call("nobody:0/open", Map.of())).getMessage()
        .contains("nobody:0/open"));
  }

  @Test
  void repliesAreRecords() throws CallException {
    add("position2d:0",
        handler("position2d:0").on(Position2d.GET_GEOMETRY, q -> Optional.of(new org.robotui.player.interfaces.Body(
            new org.robotui.player.interfaces.Pose3d(0.5, 0, 0, 0, 0, 0),
            new org.robotui.player.interfaces.Size3d(1, 2, 3)))));
    startConnected();
    await("it is known", () -> context.streams.containsKey("position2d:0"));
    DynamicRecord reply = call("position2d:0/get_geometry", Map.of());
    DynamicRecord pose = ((FieldValue.Nested) reply.field("pose").orElseThrow()).value();
    assertEquals(Optional.of(new FieldValue.Num(0.5, "0.5")), pose.field("x"));
  }

  @Test
  void browsingShowsUnitsAndOpensNothing() throws CallException {
    base();
    add("gripper:0", handler("gripper:0"));
    startConnected();
    await("they are known",
        () -> context.streams.containsKey("gripper:0") && context.streams.containsKey("position2d:0"));
    Browser browser = context.browsers.get("graph");
    List<String> topics = browser.list(Kind.TOPIC).stream().map(Browser.Item::name).toList();
    assertTrue(topics.containsAll(List.of("position2d:0/state", "position2d:0/velocity", "gripper:0/state")),
        topics.toString());
    List<String> services = browser.list(Kind.SERVICE).stream().map(Browser.Item::name).toList();
    assertTrue(
        services.containsAll(List.of("position2d:0/motor_power", "gripper:0/open", "gripper:0/get_double_property")));
    assertTrue(services.stream().noneMatch("position2d:0/velocity"::equals));

    Browser.Description state = browser.describe(new Browser.Item(Kind.TOPIC, "position2d:0/state", "state"));
    assertTrue(state.definition().orElseThrow().contains("yaw [rad]"), state.definition().toString());
    assertInstanceOf(FieldShape.Nested.class, state.shape().orElseThrow().field("position").orElseThrow().shape());
    Browser.Description power = browser.describe(new Browser.Item(Kind.SERVICE, "position2d:0/motor_power", "switch"));
    assertEquals(new FieldShape.Flag(), power.shape().orElseThrow().field("on").orElseThrow().shape());
    assertThrows(CallException.class, () -> browser.describe(new Browser.Item(Kind.SERVICE, "laser:7/power", "")));

    assertEquals(List.of("driver_of_gripper", "driver_of_position2d"),
        browser.list(Kind.NODE).stream().map(Browser.Item::name).toList());
    assertTrue(browser.links().contains(new Browser.Link("driver_of_gripper", "gripper:0/state", true)));
    assertTrue(browser.links().contains(new Browser.Link("driver_of_position2d", "position2d:0/velocity", false)));
    assertEquals(Set.of(), everOpened);
  }
}
