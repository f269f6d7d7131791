package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentLinkedDeque;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.FrameId;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.Path;
import org.robotui.data.record.FieldValue;
import org.robotui.geometry.RigidTransform;
import org.robotui.guard.Guards;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.std_msgs.StdFloat64;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.rfic.ros.internal.graph.SharedMasters;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.msgs.StandardServices;

/** What goes to the robot: commands, single messages, calls. */
class RosCommandsTest extends RosRficCase {
  @Test
  void commandsOnlyThoseWhoListen() {
    Deque<Twist> heard = new ConcurrentLinkedDeque<>();
    robot.subscriber("/cmd_vel", RecordCodec.of(Twist.class), SubscriberOptions.standard(), (t, r) -> heard.add(t));
    rfic.start();
    await(() -> context.commands.containsKey("cmd_vel"));
    assertTrue(context.commands.get("cmd_vel").isMotion());
    await(() -> send("cmd_vel", VelocityCommand.planar(0.25, -0.5)) instanceof Sent.Out);
    await(() -> !heard.isEmpty());
    assertEquals(0.25, heard.getFirst().linear().x());
    assertEquals(-0.5, heard.getFirst().angular().z());
    assertFalse(context.commands.containsKey("goal"));
  }

  @Test
  void offersConfiguredCommandsAlsoWhileNobodyListens() {
    rfic = new RosRfic(context, settings(Map.of("master", master.uri().toString(), "velocity", List.of("base/cmd"))),
        new SharedMasters(), new Guards());
    rfic.start();
    await(() -> context.commands.containsKey("base/cmd"));
    Sent sent = send("base/cmd", VelocityCommand.ZERO);
    assertEquals("nobody subscribes to /base/cmd now", assertInstanceOf(Sent.Refused.class, sent).reason());
  }

  @Test
  void sendsWaypointsToTheTopicsThatAreNamed() {
    Deque<org.robotui.message.ros.nav_msgs.Path> paths = new ConcurrentLinkedDeque<>();
    Deque<org.robotui.message.ros.geometry_msgs.PoseArray> arrays = new ConcurrentLinkedDeque<>();
    robot.subscriber("/follow", RecordCodec.of(org.robotui.message.ros.nav_msgs.Path.class),
        SubscriberOptions.standard(), (p, r) -> paths.add(p));
    robot.subscriber("/visit", RecordCodec.of(org.robotui.message.ros.geometry_msgs.PoseArray.class),
        SubscriberOptions.standard(), (p, r) -> arrays.add(p));
    rfic = new RosRfic(context,
        settings(Map.of("master", master.uri().toString(), "path", List.of("follow"), "poses", List.of("visit"))),
        new SharedMasters(), new Guards());
    rfic.start();
    await(() -> context.commands.containsKey("follow") && context.commands.containsKey("visit"));
    FrameId map = new FrameId("robby", "map");
    List<RigidTransform> poses = List.of(RigidTransform.planar(1, 2, 0), RigidTransform.planar(3, 4, 0));
    await(() -> send("follow", new Path(map, poses)) instanceof Sent.Out);
    await(() -> send("visit", new PoseArray(map, poses)) instanceof Sent.Out);
    await(() -> !paths.isEmpty() && !arrays.isEmpty());
    assertEquals("map", paths.getFirst().header().frameId());
    assertEquals("map", paths.getFirst().poses().getLast().header().frameId());
    assertEquals(4, paths.getFirst().poses().getLast().pose().position().y());
    assertEquals(List.of(1.0, 3.0), arrays.getFirst().poses().stream().map(pose -> pose.position().x()).toList());
  }

  @Test
  void aPlanThatOthersLookAtStaysNewsAndIsNoCommand() throws IOException {
    robot.publisher("/plan", RecordCodec.of(org.robotui.message.ros.nav_msgs.Path.class), PublisherOptions.standard());
    RosNode viewer = node("viewer");
    viewer.subscriber("/plan", RecordCodec.of(org.robotui.message.ros.nav_msgs.Path.class),
        SubscriberOptions.standard(), (p, r) -> {});
    viewer.subscriber("/cmd_vel", RecordCodec.of(Twist.class), SubscriberOptions.standard(), (t, r) -> {});
    rfic.start();
    await(() -> context.commands.containsKey("cmd_vel") && context.streams.containsKey("plan"));
    assertFalse(context.commands.containsKey("plan"));
    viewer.close();
  }

  @Test
  void doesNotTakeOrdersOfOthersForNewsOfTheRobot() throws IOException {
    robot.subscriber("/initialpose", RecordCodec.of(PoseWithCovarianceStamped.class), SubscriberOptions.standard(),
        (m, r) -> {});
    robot.subscriber("/cmd_vel", RecordCodec.of(Twist.class), SubscriberOptions.standard(), (m, r) -> {});
    RosNode other = node("other_workbench");
    other.publisher("/initialpose", RecordCodec.of(PoseWithCovarianceStamped.class), PublisherOptions.standard());
    other.publisher("/cmd_vel", RecordCodec.of(Twist.class), PublisherOptions.standard());
    rfic.start();
    await(() -> context.commands.containsKey("initialpose") && context.streams.containsKey("cmd_vel"));
    assertFalse(context.streams.containsKey("initialpose"));
    other.close();
  }

  @Test
  void callsServicesByNameAndSaysWhyNot() throws Exception {
    robot.serviceServer("/motors", StandardServices.SET_BOOL,
        (request, caller) -> new SetBoolResponse(request.data(), "done"));
    rfic.start();
    await(() -> context.handlers.containsKey("services"));
    assertTrue(robot.awaitRegistered(PATIENCE));
    ServiceReply reply = call("services", new ServiceRequest("/motors", Map.of("data", true)));
    assertEquals(new FieldValue.Flag(true), reply.value().field("success").orElseThrow());
    CallException wrong = org.junit.jupiter.api.Assertions.assertThrows(
        CallException.class, () -> call("services", new ServiceRequest("/motors", Map.of("dta", true))));
    assertTrue(wrong.getMessage().contains("dta"), wrong.getMessage());
    CallException none = org.junit.jupiter.api.Assertions.assertThrows(
        CallException.class, () -> call("services", new ServiceRequest("/nowhere", Map.of())));
    assertTrue(none.getMessage().contains("/nowhere"), none.getMessage());
  }

  @Test
  void saysAMessageOnceToAllWhoListenAndNeverOnTopicsThatMoveTheRobot() {
    Deque<Double> first = new ConcurrentLinkedDeque<>();
    Deque<Double> second = new ConcurrentLinkedDeque<>();
    robot.subscriber("/gain", RecordCodec.of(StdFloat64.class), SubscriberOptions.standard(),
        (m, r) -> first.add(m.data()));
    robot.subscriber("/gain", RecordCodec.of(StdFloat64.class), SubscriberOptions.standard(),
        (m, r) -> second.add(m.data()));
    robot.subscriber("/cmd_vel", RecordCodec.of(Twist.class), SubscriberOptions.standard(), (t, r) -> {});
    rfic.start();
    await(() -> context.commands.containsKey("cmd_vel"));
    await(() -> say("/gain", "std_msgs/Float64", Map.of("data", 2.5)) instanceof Sent.Out);
    await(() -> first.size() == 1 && second.size() == 1);
    assertEquals(2.5, first.getFirst());
    assertInstanceOf(Sent.Out.class, say("/gain", "std_msgs/Float64", Map.of("data", 3)));
    await(() -> first.size() == 2);
    assertTrue(refusal(say("/gain", "std_msgs/String", Map.of())).contains("carries std_msgs/Float64"));
    assertTrue(refusal(say("/gain", "std_msgs/Float64", Map.of("data", "much"))).contains("data"));
    assertTrue(refusal(say("/nobody", "std_msgs/Float64", Map.of())).contains("nobody subscribes to /nobody"));
    assertTrue(refusal(say("/cmd_vel", "geometry_msgs/Twist", Map.of())).contains("moves the robot"));
  }

  private static String refusal(Sent sent) {
    return assertInstanceOf(Sent.Refused.class, sent).reason();
  }

  @SuppressWarnings("unchecked")
  private Sent say(String topic, String type, Map<String, Object> fields) {
    return ((CommandSink<MessageCommand>) context.sinks.get("publish")).send(new MessageCommand(topic, type, fields));
  }
}
