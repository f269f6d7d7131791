package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Browser;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.RecordShape;
import org.robotui.data.sensor.LaserScan;
import org.robotui.guard.Guards;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.std_msgs.StdFloat64;
import org.robotui.rfic.ros.internal.graph.SharedMasters;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;
import org.robotui.testkit.FakeRficContext;

/** What comes from the robot, and the link to it. */
class RosRficTest extends RosRficCase {
  @Test
  void offersTopicsWhileTheyArePublishedAndAsksForThemOnlyWhenWanted() {
    Publisher<org.robotui.message.ros.sensor_msgs.LaserScan> scans =
        robot.publisher("/scan", RecordCodec.of(org.robotui.message.ros.sensor_msgs.LaserScan.class),
            PublisherOptions.standard());
    rfic.start();
    await(() -> context.streams.containsKey("scan"));
    assertEquals(LaserScan.class, context.streams.get("scan").type());
    assertEquals(0, scans.numSubscribers());
    context.demand("scan", true);
    await(() -> scans.numSubscribers() == 1);
    scans.publish(scan(new float[]{1, Float.NaN, Float.POSITIVE_INFINITY}));
    FakeRficContext.Published got = first("scan");
    LaserScan scan = (LaserScan) got.value();
    assertEquals(new FrameId("robby", "laser"), scan.frame());
    assertEquals(Stamp.of(12, 500, ClockKind.ROBOT), got.stamp().orElseThrow());
    assertEquals(List.of(true, false, false), List.of(scan.isEcho(0), scan.isEcho(1), scan.isEcho(2)));
    assertEquals("sensor_msgs/LaserScan", got.raw().orElseThrow().schema());
    context.demand("scan", false);
    await(() -> scans.numSubscribers() == 0);
    scans.close();
    await(() -> !context.streams.containsKey("scan"));
  }

  @Test
  void saysWhyAWantedTopicIsMissingAndTakesItUpAgain() throws IOException {
    RosNode driver = node("driver");
    driver.publisher("/value", RecordCodec.of(StdFloat64.class), PublisherOptions.latched()).publish(new StdFloat64(1));
    rfic.start();
    await(() -> context.streams.containsKey("value"));
    context.demand("value", true);
    assertEquals(1.0, number(first("value")));
    assertEquals(true, context.kept.get("value"), "its publisher latches");
    driver.close();
    await(() -> context.complaints.get("value").contains("nobody publishes /value any more"));
    await(() -> context.links.getLast() instanceof LinkState.Degraded);
    context.published.get("value").clear();
    driver = node("driver");
    driver.publisher("/value", RecordCodec.of(StdFloat64.class), PublisherOptions.latched()).publish(new StdFloat64(2));
    assertEquals(2.0, number(first("value")));
    driver.close();
  }

  @Test
  void takesItsComplaintBackWhenARareTopicIsThereAgainThoughItSaysNothingYet() throws IOException {
    RosNode driver = node("driver");
    driver.publisher("/rare", RecordCodec.of(StdFloat64.class), PublisherOptions.standard());
    rfic.start();
    await(() -> context.streams.containsKey("rare"));
    context.demand("rare", true);
    driver.close();
    await(() -> context.complaints.get("rare").contains("nobody publishes /rare any more"));
    driver = node("driver");
    driver.publisher("/rare", RecordCodec.of(StdFloat64.class), PublisherOptions.standard());
    await(() -> "".equals(context.complaints.get("rare").peekLast()));
    driver.close();
  }

  @Test
  void refusesMessagesThatAreNotWhatTheyShouldBeAndGoesOn() {
    Publisher<org.robotui.message.ros.sensor_msgs.LaserScan> scans =
        robot.publisher("/scan", RecordCodec.of(org.robotui.message.ros.sensor_msgs.LaserScan.class),
            PublisherOptions.standard());
    rfic.start();
    await(() -> context.streams.containsKey("scan"));
    context.demand("scan", true);
    await(() -> scans.numSubscribers() == 1);
    org.robotui.message.ros.sensor_msgs.LaserScan good = scan(new float[]{1});
    scans.publish(new org.robotui.message.ros.sensor_msgs.LaserScan(good.header(), Float.NaN, 0, 0, 0, 0, 0, 1,
        good.ranges(), new float[0]));
    scans.publish(good);
    first("scan");
    assertTrue(context.complaints.get("scan").getFirst().contains("/scan from /robot: angleMin"));
  }

  @Test
  void seesOnlyItsNamespace() throws IOException {
    robot.publisher("/r1/value", RecordCodec.of(StdFloat64.class), PublisherOptions.standard());
    robot.publisher("/r2/value", RecordCodec.of(StdFloat64.class), PublisherOptions.standard());
    rfic = new RosRfic(context, settings(Map.of("master", master.uri().toString(), "namespace", "r1")),
        new SharedMasters(), new Guards());
    rfic.start();
    await(() -> context.streams.containsKey("value"));
    assertEquals(2, context.streams.size(), () -> context.streams.keySet().toString());
  }

  @Test
  void browsesTheGraph() throws Exception {
    robot.publisher("/value", RecordCodec.of(StdFloat64.class), PublisherOptions.standard());
    rfic.start();
    await(() -> context.browsers.containsKey("graph"));
    assertTrue(robot.awaitRegistered(PATIENCE));
    Browser browser = context.browsers.get("graph");
    Browser.Item item = new Browser.Item(Browser.Kind.TOPIC, "/value", "std_msgs/Float64");
    assertTrue(browser.list(Browser.Kind.TOPIC).contains(item));
    assertEquals("/robot", browser.describe(item).facts().get("publishers"));
    assertTrue(browser.links().contains(new Browser.Link("/robot", "/value", true)));
    assertTrue(browser.list(Browser.Kind.NODE).stream().anyMatch(n -> n.name().equals("/robot")));
    browser.setParameter("/gains", Map.of("p", 1.5, "names", List.of("a", "b"), "count", 3L, "on", true));
    assertEquals(1.5, ((Map<?, ?>) browser.parameter("/gains").orElseThrow()).get("p"));
    assertTrue(browser.parameter("/none").isEmpty());
  }

  @Test
  void keepsTheRobotsNamesBesideTheDataType() {
    Publisher<org.robotui.message.ros.sensor_msgs.LaserScan> scans = robot.publisher(
        "/scan", RecordCodec.of(org.robotui.message.ros.sensor_msgs.LaserScan.class), PublisherOptions.latched());
    scans.publish(scan(new float[]{1, 2}));
    rfic.start();
    await(() -> context.streams.containsKey("scan"));
    context.demand("scan", true);
    DynamicRecord message = first("scan").raw().orElseThrow().record().orElseThrow();
    assertEquals("sensor_msgs/LaserScan", message.schema());
    assertEquals(Optional.of(new FieldValue.Num(-1, "-1.0")), message.at(FieldPath.parse("angle_min")));
    assertEquals(Optional.of(new FieldValue.Text("/laser")), message.at(FieldPath.parse("header.frame_id")));
  }

  @Test
  void describesTheFormOfMessages() throws Exception {
    robot.subscriber("/cmd_vel", RecordCodec.of(Twist.class), SubscriberOptions.standard(), (t, r) -> {});
    rfic.start();
    await(() -> context.commands.containsKey("cmd_vel"));
    Browser browser = context.browsers.get("graph");
    RecordShape twist = browser.describe(new Browser.Item(Browser.Kind.TOPIC, "/cmd_vel", "geometry_msgs/Twist"))
        .shape().orElseThrow();
    FieldShape.Nested linear = assertInstanceOf(FieldShape.Nested.class, twist.field("linear").orElseThrow().shape());
    assertEquals(Optional.of(new FieldShape.Real(64)), linear.shape().field("x").map(RecordShape.Field::shape));
  }

  @Test
  void comesBackAfterTheMaster() throws IOException {
    rfic.start();
    await(() -> context.links.peekLast() instanceof LinkState.Connected);
    int port = URI.create(master.uri().toString()).getPort();
    master.close();
    await(() -> context.links.getLast() instanceof LinkState.Failed);
    master = RosMaster.open(MasterOptions.standard(DAEMONS).withPort(port));
    await(() -> context.links.getLast() instanceof LinkState.Connected);
  }

  @Test
  void saysWhatTheRobotIsMadeOfAndSaysItAgainWhenItChanges() {
    rfic.start();
    await(() -> context.streams.containsKey("tf"));
    assertFalse(context.streams.containsKey("robot_description"));
    robot.parameters().set("/robot_description", XmlRpcValue.of("<robot name='a'/>"));
    RobotDescription first = (RobotDescription) first("robot_description").value();
    assertEquals("<robot name='a'/>", first.urdf());
    assertEquals("robby", first.robot());
    robot.parameters().set("/robot_description_semantic", XmlRpcValue.of("<robot/>"));
    await(() -> ((RobotDescription) context.published.get("robot_description").getLast().value()).srdf()
        .equals("<robot/>"));
    robot.parameters().delete("/robot_description");
    await(() -> !context.streams.containsKey("robot_description"));
  }

  @Test
  void leavesNothingBehind() {
    robot.publisher("/value", RecordCodec.of(StdFloat64.class), PublisherOptions.standard());
    robot.subscriber("/cmd_vel", RecordCodec.of(Twist.class), SubscriberOptions.standard(), (t, r) -> {});
    rfic.start();
    await(() -> context.streams.containsKey("value") && context.commands.containsKey("cmd_vel"));
    context.demand("value", true);
    rfic.close();
    await(() -> robot.master().systemState().toOptional().orElseThrow().nodes().stream()
        .noneMatch(n -> n.contains("robotui")));
    await(() -> context.alive().isEmpty());
    assertEquals(Map.of(), new HashMap<>(context.streams));
    assertEquals(Map.of(), new HashMap<>(context.commands));
  }
}
