package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.status.LogEntry;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.rcl_interfaces.RclLog;
import org.robotui.message.ros.rosgraph_msgs.Clock;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.std_msgs.StdFloat64;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor;
import org.robotui.ros2.parameter.Ros2ParameterServer;
import org.robotui.ros2.parameter.Ros2ParameterValue;
import org.robotui.ros2.tf.Ros2TfBroadcaster;
import org.robotui.testkit.FakeRficContext;

/** What comes from the robot, and the link to it. */
class Ros2StreamsTest extends Ros2Case {
  private static final Ros2Codec<StdFloat64> NUMBERS = Ros2Codec.of(StdFloat64.class);

  static double number(FakeRficContext.Published published) {
    FieldValue value = ((DynamicRecord) published.value()).at(FieldPath.parse("data")).orElseThrow();
    return ((FieldValue.Num) value).value();
  }

  private LinkState link() {
    return Optional.ofNullable(context.links.peekLast()).orElseGet(LinkState.Disconnected::new);
  }

  @Test
  void offersTopicsWhileTheyArePublishedAndAsksForThemOnlyWhenWanted() {
    Ros2Publisher<org.robotui.message.ros.sensor_msgs.LaserScan> scans = robot.publisher("scan",
        Ros2Codec.of(org.robotui.message.ros.sensor_msgs.LaserScan.class), QosProfiles.SENSOR_DATA);
    rfic.start();
    await(() -> context.streams.containsKey("scan"));
    assertEquals(LaserScan.class, context.streams.get("scan").type());
    assertEquals(0, scans.numSubscribers());
    context.demand("scan", true);
    await(() -> scans.numSubscribers() == 1);
    scans.publish(new org.robotui.message.ros.sensor_msgs.LaserScan(new Header(0, 12_000_000_500L, "laser"), -1, 1,
        0.5f, 0, 0, 0.1f, 30, new float[]{1, Float.NaN}, new float[0]));
    FakeRficContext.Published got = first("scan");
    assertEquals(new FrameId("robby", "laser"), ((LaserScan) got.value()).frame());
    assertEquals(Stamp.of(12, 500, ClockKind.ROBOT), got.stamp().orElseThrow());
    assertEquals("cdr", got.raw().orElseThrow().encoding());
    DynamicRecord message = got.raw().orElseThrow().record().orElseThrow();
    assertEquals(Optional.of(new FieldValue.Text("laser")), message.at(FieldPath.parse("header.frame_id")));
    assertEquals("best effort, volatile, keeps the last 5", context.deliveries.get("scan"));
    context.demand("scan", false);
    await(() -> scans.numSubscribers() == 0);
    scans.close();
    await(() -> !context.streams.containsKey("scan"));
  }

  @Test
  void saysWhyAWantedTopicIsMissingAndTakesItUpAgain() throws Exception {
    Ros2Node driver = node("driver");
    driver.publisher("value", NUMBERS, QosProfiles.LATCHED).publish(new StdFloat64(1));
    rfic.start();
    await(() -> context.streams.containsKey("value"));
    context.demand("value", true);
    assertEquals(1.0, number(first("value")));
    assertEquals(true, context.kept.get("value"), "its publisher keeps it");
    driver.close();
    await(() -> context.complaints.get("value").contains("nobody publishes /value any more"));
    await(() -> link() instanceof LinkState.Degraded);
    context.published.get("value").clear();
    robot.publisher("value", NUMBERS, QosProfiles.LATCHED).publish(new StdFloat64(2));
    assertEquals(2.0, number(first("value")));
    await(() -> link() instanceof LinkState.Connected);
  }

  @Test
  void seesOnlyItsNamespaceAndKnowsWhetherARobotIsThere() {
    robot.publisher("/r2/value", NUMBERS, QosProfiles.DEFAULT);
    rfic(context, Map.of("namespace", "r1")).start();
    await(() -> link().reason().startsWith("no program of a robot in the namespace /r1/ is heard"));
    robot.publisher("/r1/value", NUMBERS, QosProfiles.DEFAULT);
    await(() -> link() instanceof LinkState.Connected && context.streams.containsKey("value"));
    assertFalse(context.streams.containsKey("r2/value"), () -> context.streams.keySet().toString());
  }

  @Test
  void interfacesOfOneProcessAreNoRobotsToEachOther() throws Exception {
    robot.publisher("cmd_vel", Ros2Codec.of(Twist.class), QosProfiles.DEFAULT);
    FakeRficContext other = new FakeRficContext();
    rfic(other, Map.of()).start();
    await(() -> other.streams.containsKey("cmd_vel"));
    other.demand("cmd_vel", true);
    Ros2Node witness = node("witness");
    await(() -> witness.context().graph().state().topics().stream()
        .anyMatch(topic -> topic.name().text().equals("/cmd_vel") && !topic.subscribers().isEmpty()));
    rfic.start();
    await(() -> context.streams.containsKey("cmd_vel"));
    assertFalse(context.commands.containsKey("cmd_vel"), "one of ours listens to it, and nobody else");
    witness.context().close();
    robot.context().close();
    await(() -> link() instanceof LinkState.Failed);
  }

  @Test
  void followsSimulatedTimeWhileSomebodySaysIt() {
    Ros2Publisher<Clock> clock = robot.publisher("/clock", Ros2Codec.of(Clock.class), QosProfiles.CLOCK);
    rfic.start();
    await(() -> {
      clock.publish(new Clock(5_000_000_000L));
      return context.simulated.contains(5_000_000_000L);
    });
    clock.close();
    await(() -> context.simulated.isEmpty());
  }

  @Test
  void bringsTransformsThatMoveAndThatHoldForGood() {
    Ros2TfBroadcaster broadcaster = new Ros2TfBroadcaster(robot);
    Transform shift = new Transform(new Vector3(1, 2, 3), new Quaternion(0, 0, 0, 1));
    broadcaster.sendStatic(List.of(new TransformStamped(new Header(0, 1, "base_link"), "laser", shift)));
    rfic.start();
    await(() -> {
      broadcaster.send(List.of(new TransformStamped(new Header(0, 1_000, "odom"), "base_link", shift)));
      return context.transforms.stream().map(t -> t.child()).toList()
          .containsAll(List.of(new FrameId("robby", "laser"), new FrameId("robby", "base_link")));
    });
  }

  @Test
  void bringsTransformsThatARobotSaysInItsNamespace() {
    Ros2Publisher<TFMessage> transforms = robot.publisher("/r1/tf", Ros2Codec.of(TFMessage.class), QosProfiles.TF);
    Transform shift = new Transform(new Vector3(1, 2, 3), new Quaternion(0, 0, 0, 1));
    rfic(context, Map.of("namespace", "r1")).start();
    await(() -> {
      transforms
          .publish(new TFMessage(List.of(new TransformStamped(new Header(0, 1_000, "odom"), "base_link", shift))));
      return context.transforms.stream().anyMatch(t -> t.child().equals(new FrameId("robby", "base_link")));
    });
    transforms.close();
    await(() -> transforms.numSubscribers() == 0);
  }

  @Test
  void bringsTheLog() {
    Ros2Publisher<RclLog> log = robot.publisher("/rosout", Ros2Codec.of(RclLog.class), QosProfiles.LOG);
    log.publish(new RclLog(7_000_000_000L, (short) 30, "base", "the battery is low", "base.cpp", "check", 12));
    rfic.start();
    await(() -> context.streams.containsKey("rosout"));
    context.demand("rosout", true);
    LogEntry entry = (LogEntry) first("rosout").value();
    assertEquals("the battery is low", entry.message());
  }

  @Test
  void saysWhatTheRobotIsMadeOf() {
    rfic.start();
    await(() -> context.streams.containsKey("tf"));
    assertFalse(context.streams.containsKey("robot_description"));
    Ros2Publisher<StdString> description =
        robot.publisher("robot_description", Ros2Codec.of(StdString.class), QosProfiles.LATCHED);
    description.publish(new StdString("<robot name='a'/>"));
    RobotDescription first = (RobotDescription) first("robot_description").value();
    assertEquals("<robot name='a'/>", first.urdf());
    robot.publisher("robot_description_semantic", Ros2Codec.of(StdString.class), QosProfiles.LATCHED)
        .publish(new StdString("<robot/>"));
    await(() -> ((RobotDescription) context.published.get("robot_description").getLast().value()).srdf()
        .equals("<robot/>"));
    description.close();
    await(() -> !context.streams.containsKey("robot_description"));
  }

  private String urdf() {
    return Optional.ofNullable(context.published.get("robot_description")).flatMap(all -> Optional.ofNullable(
        all.peekLast())).map(last -> ((RobotDescription) last.value()).urdf()).orElse("");
  }

  @Test
  void readsWhatTheRobotIsMadeOfFromAParameterWhereNoTopicSaysIt() throws Exception {
    Ros2ParameterServer.open(node("aaa"));
    Ros2Node speaking = node("my_robot_state_publisher");
    Ros2ParameterServer server = Ros2ParameterServer.open(speaking);
    Ros2ParameterValue first = new Ros2ParameterValue.OfText("<robot name='p'/>");
    server.declare(Ros2ParameterDescriptor.of("robot_description", first, ""), first, value -> Optional.empty());
    rfic.start();
    await(() -> urdf().equals("<robot name='p'/>"));
    await(() -> {
      server.set("robot_description", new Ros2ParameterValue.OfText("<robot name='q'/>"));
      return urdf().equals("<robot name='q'/>");
    });
    Ros2Publisher<StdString> topic =
        robot.publisher("robot_description", Ros2Codec.of(StdString.class), QosProfiles.LATCHED);
    topic.publish(new StdString("<robot name='t'/>"));
    await(() -> urdf().equals("<robot name='t'/>"));
    topic.close();
    await(() -> !context.streams.containsKey("robot_description") || urdf().equals("<robot name='q'/>"));
    await(() -> urdf().equals("<robot name='q'/>") && context.streams.containsKey("robot_description"));
    speaking.close();
    await(() -> !context.streams.containsKey("robot_description"));
  }

  @Test
  void leavesNothingBehind() {
    robot.publisher("value", NUMBERS, QosProfiles.DEFAULT);
    robot.subscriber("cmd_vel", Ros2Codec.of(Twist.class), Ros2SubscriberOptions.observing(), (t, from) -> {});
    rfic.start();
    await(() -> context.streams.containsKey("value") && context.commands.containsKey("cmd_vel"));
    context.demand("value", true);
    await(() -> others() > 0);
    rfic.close();
    await(() -> others() == 0);
    await(() -> context.alive().isEmpty());
    assertTrue(context.streams.isEmpty() && context.commands.isEmpty() && context.browsers.isEmpty());
  }

  private long others() {
    return robot.context().graph().state().nodes().stream().filter(node -> !node.own()).count();
  }
}
