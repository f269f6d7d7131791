package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.ActionSchema;
import org.robotui.message.DynamicMessage;
import org.robotui.message.SchemaLookup;
import org.robotui.message.description.TypeName;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.rcl_interfaces.RclLog;
import org.robotui.message.ros.rosgraph_msgs.Clock;
import org.robotui.message.ros.sensor_msgs.CompressedImage;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersRequest;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersResponse;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Options;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.action.Ros2ActionClient;
import org.robotui.ros2.action.Ros2ActionOptions;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalHandle;
import org.robotui.ros2.action.Ros2GoalListener;
import org.robotui.ros2.action.Ros2GoalOutcome;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor.DoubleRange;
import org.robotui.ros2.parameter.Ros2ParameterValue.OfDouble;
import org.robotui.ros2.parameter.Ros2Parameters;

/** The whole demo over loopback, seen by another node of ROS 2. Runs ten times faster than real. */
class DemoRos2Test {
  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final TypeName NAVIGATE = TypeName.parse("nav2_msgs/action/NavigateToPose").orElseThrow();

  private Demo demo;
  private Ros2Context context;
  private Ros2Node observer;

  @BeforeEach
  void start() throws IOException {
    demo = Demo.start(Options.parse(List.of("--speak", "ros,ros2", "--namespace", "keira", "--name", "base",
        "--speed-factor", "10", "--sim-time", "cmd_vel:=drive")));
    int domain = Integer.parseInt(demo.addresses().get("ROS_DOMAIN_ID"));
    context = Ros2Context.open(Ros2Environment.local(domain),
        Ros2Options.standard(task -> Thread.ofPlatform().daemon().unstarted(task)));
    observer = context.node("observer");
  }

  @AfterEach
  void end() {
    context.close();
    demo.close();
  }

  private <T extends Record> BlockingQueue<T> listen(String topic, Class<T> type) {
    BlockingQueue<T> queue = new LinkedBlockingQueue<>();
    observer.subscriber(topic, Ros2Codec.of(type), Ros2SubscriberOptions.observing(),
        (message, from) -> queue.add(message));
    return queue;
  }

  private static <T> T await(BlockingQueue<T> queue, Predicate<T> wanted) throws InterruptedException {
    long end = System.nanoTime() + PATIENCE.toNanos();
    Optional<T> message = Optional.empty();
    while (message.filter(wanted).isEmpty()) {
      message = Optional.ofNullable(queue.poll(end - System.nanoTime(), TimeUnit.NANOSECONDS));
      assertTrue(message.isPresent(), "no such message within " + PATIENCE);
    }
    return message.get();
  }

  @Test
  void sensorsMapAndDescriptionArriveInTheirFrames() throws InterruptedException {
    BlockingQueue<LaserScan> scans = listen("/keira/scan", LaserScan.class);
    BlockingQueue<CompressedImage> pictures = listen("/keira/camera/image_raw/compressed", CompressedImage.class);
    OccupancyGrid map = await(listen("/keira/map", OccupancyGrid.class), any -> true);
    TFMessage fixed = await(listen("/tf_static", TFMessage.class), any -> true);
    StdString description = await(listen("/keira/robot_description", StdString.class), any -> true);
    assertEquals("map", map.header().frameId());
    assertEquals("keira/laser", await(scans, any -> true).header().frameId());
    assertEquals(22, fixed.transforms().size());
    assertTrue(description.data().contains("<link name=\"keira/left_wheel_link\">"));
    assertEquals((byte) 0xd8, await(pictures, any -> true).data().get(1));
    assertTrue(await(listen("/clock", Clock.class), any -> true).clock() < Duration.ofHours(1).toNanos());
  }

  @Test
  void itDrivesOnTheTopicThatItWasGivenWithinTheParametersAndStopsByItself() throws InterruptedException {
    try (Ros2Parameters parameters = Ros2Parameters.open(observer, Ros2Name.of("/keira/base"), PATIENCE)) {
      var described = parameters.describe(List.of("max_linear_speed")).toOptional().orElseThrow();
      assertEquals(Optional.of(new DoubleRange(0.05, 1.5, 0)), described.get("max_linear_speed").doubles());
      assertInstanceOf(Outcome.Done.class, parameters.set("max_linear_speed", new OfDouble(0.4)));
      assertInstanceOf(Outcome.Refused.class, parameters.set("max_linear_speed", new OfDouble(4)));
    }
    BlockingQueue<Odometry> odometry = listen("/keira/odom", Odometry.class);
    Ros2Publisher<Twist> command =
        observer.publisher("/keira/drive", Ros2Codec.of(Twist.class), QosProfiles.LATCHED);
    command.publish(new Twist(new Vector3(5, 0, 0), new Vector3(0, 0, 0)));
    await(odometry, message -> message.twist().twist().linear().x() > 0.3);
    Odometry still = await(odometry, message -> message.twist().twist().linear().x() == 0
        || message.twist().twist().linear().x() > 0.4001);
    assertEquals(0, still.twist().twist().linear().x());
  }

  @Test
  void servicesAreAnsweredAndWhatHappensIsLogged() throws InterruptedException {
    BlockingQueue<RclLog> log = listen("/rosout", RclLog.class);
    var switching = Ros2ServiceCodec.of("std_srvs/srv/SetBool", SetBoolRequest.class, SetBoolResponse.class);
    assertEquals(new Outcome.Done<>(new SetBoolResponse(true, "motors off")),
        observer.serviceClient("/keira/motors", switching).call(new SetBoolRequest(false), PATIENCE));
    RclLog line = await(log, entry -> entry.msg().equals("motors off"));
    assertEquals("keira.base", line.name());
    assertEquals(RclLog.INFO, line.level());
    var asking = Ros2ServiceCodec.of("visualization_msgs/srv/GetInteractiveMarkers",
        GetInteractiveMarkersRequest.class, GetInteractiveMarkersResponse.class);
    GetInteractiveMarkersResponse markers =
        observer.serviceClient("/keira/waypoint/get_interactive_markers", asking)
            .call(new GetInteractiveMarkersRequest(), PATIENCE).toOptional().orElseThrow();
    assertEquals("waypoint", markers.markers().get(0).name());
  }

  @Test
  void goalsAreReachedRejectedReplacedAndCancelled() throws Exception {
    SchemaLookup<ActionSchema> lookup = context.types().registry().action(NAVIGATE, Optional.empty());
    ActionSchema schema = ((SchemaLookup.Found<ActionSchema>) lookup).schema();
    BlockingQueue<DynamicMessage> feedback = new LinkedBlockingQueue<>();
    Ros2GoalListener listener = new Ros2GoalListener() {
      @Override
      public void onFeedback(DynamicMessage told) {
        feedback.add(told);
      }
    };
    try (Ros2ActionClient client = Ros2ActionClient.open(observer, "/keira/navigate_to_pose",
        new TypedAction(NAVIGATE, schema), Ros2ActionOptions.standard(Thread::new))) {
      Ros2GoalHandle near = sent(client.send(goal("keira/base_link", 0.8, 0), listener, PATIENCE));
      assertEquals(Ros2GoalEnd.SUCCEEDED, ended(near).end());
      assertEquals("map", feedback.take().text("current_pose.header.frame_id").orElseThrow());
      assertTrue(client.send(goal("moon", 1, 1), listener, PATIENCE).toOptional().isEmpty());
      Ros2GoalHandle far = sent(client.send(goal("map", 12, 5), listener, PATIENCE));
      Ros2GoalHandle other = sent(client.send(goal("map", 8, 5), listener, PATIENCE));
      Ros2GoalOutcome replaced = ended(far);
      assertEquals(Ros2GoalEnd.ABORTED, replaced.end());
      assertEquals("goal replaced", replaced.result().orElseThrow().text("error_msg").orElseThrow());
      other.cancel();
      assertEquals(Ros2GoalEnd.CANCELED, ended(other).end());
    }
  }

  private static Map<String, ?> goal(String frame, double x, double y) {
    return Map.of("pose", Map.of("header", Map.of("frame_id", frame),
        "pose", Map.of("position", Map.of("x", x, "y", y), "orientation", Map.of("w", 1))));
  }

  private static Ros2GoalHandle sent(Outcome<Ros2GoalHandle> outcome) {
    return outcome.toOptional().orElseThrow(() -> new AssertionError(outcome.toString()));
  }

  private static Ros2GoalOutcome ended(Ros2GoalHandle goal) throws Exception {
    return goal.done().toCompletableFuture().get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
  }
}
