package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.time.Duration;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.DynamicRecord;
import org.robotui.data.FieldPath;
import org.robotui.data.FieldShape;
import org.robotui.data.FieldValue;
import org.robotui.data.FrameId;
import org.robotui.data.LaserScan;
import org.robotui.data.MessageCommand;
import org.robotui.data.Path;
import org.robotui.data.PoseArray;
import org.robotui.data.RecordShape;
import org.robotui.data.RobotDescription;
import org.robotui.data.Stamp;
import org.robotui.data.VelocityCommand;
import org.robotui.geometry.RigidTransform;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;
import org.robotui.ros.msgs.StandardServices;
import org.robotui.ros.msgs.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.ros.msgs.geometry_msgs.Twist;
import org.robotui.ros.msgs.std_msgs.Header;
import org.robotui.ros.msgs.std_msgs.StdFloat64;
import org.robotui.ros.msgs.std_srvs.SetBoolResponse;

class RosRficTest {
  private static final ThreadFactory DAEMONS = Thread.ofPlatform().daemon().factory();
  private static final Duration PATIENCE = Duration.ofSeconds(15);

  private final FakeRficContext context = new FakeRficContext();
  private RosMaster master;
  private RosNode robot;
  private RosRfic rfic;

  @BeforeEach
  void openRobot() throws IOException {
    master = RosMaster.open(MasterOptions.standard(DAEMONS));
    robot = node("robot");
    rfic = new RosRfic(context, settings(Map.of("master", master.uri().toString())));
  }

  @AfterEach
  void closeAll() {
    rfic.close();
    robot.close();
    master.close();
  }

  @Test
  void offersTopicsWhileTheyArePublishedAndAsksForThemOnlyWhenWanted() {
    Publisher<org.robotui.ros.msgs.sensor_msgs.LaserScan> scans =
        robot.publisher("/scan", org.robotui.ros.msgs.sensor_msgs.LaserScan.CODEC, PublisherOptions.standard());
    rfic.start();
    await(() -> context.streams.containsKey("scan"));
    assertEquals(LaserScan.class, context.streams.get("scan").type());
    assertEquals(0, scans.numSubscribers());
    context.demand("scan", true);
    await(() -> scans.numSubscribers() == 1);
    scans.publish(scan(new float[] {1, Float.NaN, Float.POSITIVE_INFINITY}));
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
    driver.publisher("/value", StdFloat64.CODEC, PublisherOptions.latched()).publish(new StdFloat64(1));
    rfic.start();
    await(() -> context.streams.containsKey("value"));
    context.demand("value", true);
    assertEquals(1.0, number(first("value")));
    driver.close();
    await(() -> context.complaints.get("value").contains("nobody publishes /value any more"));
    await(() -> context.links.getLast() instanceof LinkState.Degraded);
    context.published.get("value").clear();
    driver = node("driver");
    driver.publisher("/value", StdFloat64.CODEC, PublisherOptions.latched()).publish(new StdFloat64(2));
    assertEquals(2.0, number(first("value")));
    driver.close();
  }

  @Test
  void takesItsComplaintBackWhenARareTopicIsThereAgainThoughItSaysNothingYet() throws IOException {
    RosNode driver = node("driver");
    driver.publisher("/rare", StdFloat64.CODEC, PublisherOptions.standard());
    rfic.start();
    await(() -> context.streams.containsKey("rare"));
    context.demand("rare", true);
    driver.close();
    await(() -> context.complaints.get("rare").contains("nobody publishes /rare any more"));
    driver = node("driver");
    driver.publisher("/rare", StdFloat64.CODEC, PublisherOptions.standard());
    await(() -> "".equals(context.complaints.get("rare").peekLast()));
    driver.close();
  }

  @Test
  void refusesMessagesThatAreNotWhatTheyShouldBeAndGoesOn() {
    Publisher<org.robotui.ros.msgs.sensor_msgs.LaserScan> scans =
        robot.publisher("/scan", org.robotui.ros.msgs.sensor_msgs.LaserScan.CODEC, PublisherOptions.standard());
    rfic.start();
    await(() -> context.streams.containsKey("scan"));
    context.demand("scan", true);
    await(() -> scans.numSubscribers() == 1);
    org.robotui.ros.msgs.sensor_msgs.LaserScan good = scan(new float[] {1});
    scans.publish(new org.robotui.ros.msgs.sensor_msgs.LaserScan(good.header(), Float.NaN, 0, 0, 0, 0, 0, 1, good.ranges(), new float[0]));
    scans.publish(good);
    first("scan");
    assertTrue(context.complaints.get("scan").getFirst().contains("/scan from /robot: angleMin"));
  }

  @Test
  void commandsOnlyThoseWhoListen() {
    Deque<Twist> heard = new ConcurrentLinkedDeque<>();
    robot.subscriber("/cmd_vel", Twist.CODEC, SubscriberOptions.standard(), (t, r) -> heard.add(t));
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
    rfic = new RosRfic(context, settings(Map.of("master", master.uri().toString(), "velocity", List.of("base/cmd"))));
    rfic.start();
    await(() -> context.commands.containsKey("base/cmd"));
    Sent sent = send("base/cmd", VelocityCommand.ZERO);
    assertEquals("nobody listens on /base/cmd now", assertInstanceOf(Sent.Refused.class, sent).reason());
  }

  @Test
  void sendsWaypointsToTheTopicsThatAreNamed() {
    Deque<org.robotui.ros.msgs.nav_msgs.Path> paths = new ConcurrentLinkedDeque<>();
    Deque<org.robotui.ros.msgs.geometry_msgs.PoseArray> arrays = new ConcurrentLinkedDeque<>();
    robot.subscriber("/follow", org.robotui.ros.msgs.nav_msgs.Path.CODEC, SubscriberOptions.standard(), (p, r) -> paths.add(p));
    robot.subscriber("/visit", org.robotui.ros.msgs.geometry_msgs.PoseArray.CODEC, SubscriberOptions.standard(), (p, r) -> arrays.add(p));
    rfic = new RosRfic(context, settings(Map.of("master", master.uri().toString(), "path", List.of("follow"), "poses", List.of("visit"))));
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
    robot.publisher("/plan", org.robotui.ros.msgs.nav_msgs.Path.CODEC, PublisherOptions.standard());
    RosNode viewer = node("viewer");
    viewer.subscriber("/plan", org.robotui.ros.msgs.nav_msgs.Path.CODEC, SubscriberOptions.standard(), (p, r) -> { });
    viewer.subscriber("/cmd_vel", Twist.CODEC, SubscriberOptions.standard(), (t, r) -> { });
    rfic.start();
    await(() -> context.commands.containsKey("cmd_vel") && context.streams.containsKey("plan"));
    assertFalse(context.commands.containsKey("plan"));
    viewer.close();
  }

  @Test
  void seesOnlyItsNamespace() throws IOException {
    robot.publisher("/r1/value", StdFloat64.CODEC, PublisherOptions.standard());
    robot.publisher("/r2/value", StdFloat64.CODEC, PublisherOptions.standard());
    rfic = new RosRfic(context, settings(Map.of("master", master.uri().toString(), "namespace", "r1")));
    rfic.start();
    await(() -> context.streams.containsKey("value"));
    assertEquals(2, context.streams.size(), () -> context.streams.keySet().toString());
  }

  @Test
  void doesNotTakeOrdersOfOthersForNewsOfTheRobot() throws IOException {
    robot.subscriber("/initialpose", PoseWithCovarianceStamped.CODEC, SubscriberOptions.standard(), (m, r) -> { });
    robot.subscriber("/cmd_vel", Twist.CODEC, SubscriberOptions.standard(), (m, r) -> { });
    RosNode other = node("other_workbench");
    other.publisher("/initialpose", PoseWithCovarianceStamped.CODEC, PublisherOptions.standard());
    other.publisher("/cmd_vel", Twist.CODEC, PublisherOptions.standard());
    rfic.start();
    await(() -> context.commands.containsKey("initialpose") && context.streams.containsKey("cmd_vel"));
    assertFalse(context.streams.containsKey("initialpose"));
    other.close();
  }

  @Test
  void callsServicesByNameAndSaysWhyNot() throws Exception {
    robot.serviceServer("/motors", StandardServices.SET_BOOL, (request, caller) -> new SetBoolResponse(request.data(), "done"));
    rfic.start();
    await(() -> context.handlers.containsKey("services"));
    assertTrue(robot.awaitRegistered(PATIENCE));
    ServiceReply reply = call(new ServiceRequest("/motors", Map.of("data", true)));
    assertEquals(new FieldValue.Flag(true), reply.value().field("success").orElseThrow());
    CallException wrong = org.junit.jupiter.api.Assertions.assertThrows(
        CallException.class, () -> call(new ServiceRequest("/motors", Map.of("dta", true))));
    assertTrue(wrong.getMessage().contains("dta"), wrong.getMessage());
    CallException none = org.junit.jupiter.api.Assertions.assertThrows(
        CallException.class, () -> call(new ServiceRequest("/nowhere", Map.of())));
    assertTrue(none.getMessage().contains("/nowhere"), none.getMessage());
  }

  @Test
  void browsesTheGraph() throws Exception {
    robot.publisher("/value", StdFloat64.CODEC, PublisherOptions.standard());
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
  void saysAMessageOnceToAllWhoListenAndNeverOnTopicsThatMoveTheRobot() {
    Deque<Double> first = new ConcurrentLinkedDeque<>();
    Deque<Double> second = new ConcurrentLinkedDeque<>();
    robot.subscriber("/gain", StdFloat64.CODEC, SubscriberOptions.standard(), (m, r) -> first.add(m.data()));
    robot.subscriber("/gain", StdFloat64.CODEC, SubscriberOptions.standard(), (m, r) -> second.add(m.data()));
    robot.subscriber("/cmd_vel", Twist.CODEC, SubscriberOptions.standard(), (t, r) -> { });
    rfic.start();
    await(() -> context.commands.containsKey("cmd_vel"));
    await(() -> say("/gain", "std_msgs/Float64", Map.of("data", 2.5)) instanceof Sent.Out);
    await(() -> first.size() == 1 && second.size() == 1);
    assertEquals(2.5, first.getFirst());
    assertInstanceOf(Sent.Out.class, say("/gain", "std_msgs/Float64", Map.of("data", 3)));
    await(() -> first.size() == 2);
    assertTrue(refusal(say("/gain", "std_msgs/String", Map.of())).contains("carries std_msgs/Float64"));
    assertTrue(refusal(say("/gain", "std_msgs/Float64", Map.of("data", "much"))).contains("data"));
    assertTrue(refusal(say("/nobody", "std_msgs/Float64", Map.of())).contains("nobody listens on /nobody"));
    assertTrue(refusal(say("/cmd_vel", "geometry_msgs/Twist", Map.of())).contains("moves the robot"));
  }

  private static String refusal(Sent sent) {
    return assertInstanceOf(Sent.Refused.class, sent).reason();
  }

  @SuppressWarnings("unchecked")
  private Sent say(String topic, String type, Map<String, Object> fields) {
    return ((CommandSink<MessageCommand>) context.sinks.get("publish")).send(new MessageCommand(topic, type, fields));
  }

  @Test
  void keepsTheRobotsNamesBesideTheDataType() {
    Publisher<org.robotui.ros.msgs.sensor_msgs.LaserScan> scans = robot.publisher(
        "/scan", org.robotui.ros.msgs.sensor_msgs.LaserScan.CODEC, PublisherOptions.latched());
    scans.publish(scan(new float[] {1, 2}));
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
    robot.subscriber("/cmd_vel", Twist.CODEC, SubscriberOptions.standard(), (t, r) -> { });
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
    await(() -> ((RobotDescription) context.published.get("robot_description").getLast().value()).srdf().equals("<robot/>"));
    robot.parameters().delete("/robot_description");
    await(() -> !context.streams.containsKey("robot_description"));
  }

  @Test
  void leavesNothingBehind() {
    robot.publisher("/value", StdFloat64.CODEC, PublisherOptions.standard());
    robot.subscriber("/cmd_vel", Twist.CODEC, SubscriberOptions.standard(), (t, r) -> { });
    rfic.start();
    await(() -> context.streams.containsKey("value") && context.commands.containsKey("cmd_vel"));
    context.demand("value", true);
    rfic.close();
    await(() -> robot.master().systemState().toOptional().orElseThrow().nodes().stream().noneMatch(n -> n.contains("robotui")));
    await(() -> context.alive().isEmpty());
    assertEquals(Map.of(), new HashMap<>(context.streams));
    assertEquals(Map.of(), new HashMap<>(context.commands));
  }

  private RosNode node(String name) throws IOException {
    return RosNode.open(RosEnvironment.of(URI.create(master.uri().toString())), GraphName.of(name), NodeOptions.standard(DAEMONS));
  }

  private static RosSettings settings(Map<String, Object> written) {
    Map<String, Object> values = new HashMap<>();
    RosSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(written);
    written.keySet().forEach(k -> assertTrue(RosSettings.SCHEMA.find(k).map(Setting::name).isPresent()));
    return RosSettings.of(new Settings(RosSettings.SCHEMA, values), Map.of());
  }

  private static org.robotui.ros.msgs.sensor_msgs.LaserScan scan(float[] ranges) {
    Header header = new Header(0, Stamp.of(12, 500, ClockKind.ROBOT).nanos(), "/laser");
    return new org.robotui.ros.msgs.sensor_msgs.LaserScan(header, -1, 1, 0.5f, 0, 0, 0.1f, 30, ranges, new float[0]);
  }

  private FakeRficContext.Published first(String port) {
    await(() -> context.published.containsKey(port) && !context.published.get(port).isEmpty());
    return context.published.get(port).getFirst();
  }

  private static double number(FakeRficContext.Published published) {
    FieldValue value = ((DynamicRecord) published.value()).at(FieldPath.parse("data")).orElseThrow();
    return ((FieldValue.Num) value).value();
  }

  @SuppressWarnings("unchecked")
  private Sent send(String port, Data command) {
    return ((CommandSink<Data>) context.sinks.get(port)).send(command);
  }

  @SuppressWarnings("unchecked")
  private ServiceReply call(ServiceRequest request) throws CallException, InterruptedException {
    CallHandler<ServiceRequest, ServiceReply> handler =
        (CallHandler<ServiceRequest, ServiceReply>) context.handlers.get("services");
    return handler.handle(new CallHandler.Invocation<>() {
      @Override
      public ServiceRequest request() {
        return request;
      }

      @Override
      public long deadlineNanos() {
        return System.nanoTime() + Duration.ofSeconds(3).toNanos();
      }

      @Override
      public void progress(double fraction, String message) {
        // services have no progress
      }

      @Override
      public void feedback(DynamicRecord record) {
        // nor feedback
      }
    });
  }

  private static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain");
      LockSupport.parkNanos(5_000_000);
    }
  }
}
