package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageCodec;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.rosgraph_msgs.Clock;
import org.robotui.message.ros.rosgraph_msgs.Log;
import org.robotui.message.ros.sensor_msgs.CompressedImage;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.sensor_msgs.Range;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.msgs.StandardServices;

/** The whole demo over loopback, seen by another node. Runs ten times faster than real. */
class DemoTest {
  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final GraphName OBSERVER = GraphName.of("observer");

  private Demo demo;
  private RosNode observer;

  @BeforeEach
  void start() throws IOException {
    demo = Demo.start(Options.parse(List.of(
        "--namespace", "keira", "--name", "base", "--speed-factor", "10", "--sim-time", "_max_linear_speed:=0.5")));
    NodeOptions options = NodeOptions.standard(task -> Thread.ofPlatform().daemon().unstarted(task));
    observer = RosNode.open(RosEnvironment.of(demo.masterUri()), OBSERVER, options);
  }

  @AfterEach
  void end() {
    observer.close();
    demo.close();
  }

  private <T> BlockingQueue<T> listen(String topic, MessageCodec<T> codec) {
    BlockingQueue<T> queue = new LinkedBlockingQueue<>();
    observer.subscriber(topic, codec, SubscriberOptions.standard(), (message, from) -> queue.add(message));
    return queue;
  }

  private static <T> T await(BlockingQueue<T> queue, Predicate<T> wanted) throws InterruptedException {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (true) {
      T message = queue.poll(end - System.nanoTime(), TimeUnit.NANOSECONDS);
      if (message == null) {
        throw new AssertionError("no such message within " + PATIENCE.toSeconds() + " s");
      }
      if (wanted.test(message)) {
        return message;
      }
    }
  }

  @Test
  void sensorsAndMapArriveInTheirFrames() throws InterruptedException {
    BlockingQueue<LaserScan> scans = listen("/keira/scan", RecordCodec.of(LaserScan.class));
    BlockingQueue<Range> sonars = listen("/keira/sonar", RecordCodec.of(Range.class));
    BlockingQueue<CompressedImage> pictures =
        listen("/keira/camera/image_raw/compressed", RecordCodec.of(CompressedImage.class));
    OccupancyGrid map = await(listen("/keira/map", RecordCodec.of(OccupancyGrid.class)), any -> true);
    TFMessage fixed = await(listen("/tf_static", RecordCodec.of(TFMessage.class)), any -> true);
    assertEquals("map", map.header().frameId());
    assertEquals("keira/laser", await(scans, any -> true).header().frameId());
    await(sonars, range -> range.header().frameId().equals("keira/sonar_15"));
    assertEquals(22, fixed.transforms().size());
    CompressedImage picture = await(pictures, any -> true);
    assertEquals((byte) 0xff, picture.data().get(0));
    assertEquals((byte) 0xd8, picture.data().get(1));
  }

  @Test
  void itSaysWhatItIsMadeOfWithLinksNamedAsItsFrames() throws InterruptedException {
    XmlRpcValue told = observer.parameters().get("/keira/robot_description").toOptional().orElseThrow();
    String urdf = ((XmlRpcValue.Text) told).value();
    TFMessage moving =
        await(listen("/tf", RecordCodec.of(TFMessage.class)), message -> message.transforms().size() > 2);
    List<String> frames = moving.transforms().stream().map(transform -> transform.childFrameId())
        .filter(name -> !name.endsWith("odom")).toList();
    assertTrue(frames.contains("keira/left_wheel_link"), frames.toString());
    frames.forEach(frame -> assertTrue(urdf.contains("<link name=\"" + frame + "\">"), frame));
  }

  @Test
  void itDrivesAsToldWithinTheParametersAndStopsByItself() throws InterruptedException {
    BlockingQueue<Odometry> odometry = listen("/keira/odom", RecordCodec.of(Odometry.class));
    Publisher<Twist> command =
        observer.publisher("/keira/cmd_vel", RecordCodec.of(Twist.class), PublisherOptions.latched());
    command.publish(new Twist(new Vector3(5, 0, 0), new Vector3(0, 0, 0)));
    Odometry fast = await(odometry, message -> message.twist().twist().linear().x() > 0.3);
    await(odometry, message -> message.twist().twist().linear().x() == 0);
    assertTrue(fast.twist().twist().linear().x() <= 0.5);
    assertEquals(
        new XmlRpcValue.Real(0.5),
        observer.parameters().get("/keira/base/max_linear_speed").toOptional().orElseThrow());
  }

  @Test
  void itDrivesToAGoalGivenInItsOwnFrame() throws InterruptedException {
    BlockingQueue<Log> log = listen("/rosout", RecordCodec.of(Log.class));
    Publisher<PoseStamped> goal =
        observer.publisher("/keira/move_base_simple/goal", RecordCodec.of(PoseStamped.class),
            PublisherOptions.latched());
    var ahead = new org.robotui.message.ros.geometry_msgs.Pose(
        new org.robotui.message.ros.geometry_msgs.Point(1, 0, 0),
        new org.robotui.message.ros.geometry_msgs.Quaternion(0, 0, 0, 1));
    goal.publish(new PoseStamped(new Header(0, 0, "keira/base_link"), ahead));
    await(log, entry -> entry.msg().startsWith("goal accepted"));
    await(log, entry -> entry.msg().equals("goal reached"));
  }

  @Test
  void servicesAreAnswered() throws InterruptedException {
    BlockingQueue<Log> log = listen("/rosout", RecordCodec.of(Log.class));
    try (var motors = observer.serviceClient("/keira/motors", StandardServices.SET_BOOL, false)) {
      Outcome<SetBoolResponse> answer = motors.call(new SetBoolRequest(false), PATIENCE);
      assertTrue(assertInstanceOf(Outcome.Done.class, answer).value() instanceof SetBoolResponse r && r.success());
    }
    await(log, entry -> entry.msg().equals("motors off"));
  }

  @Test
  void timeIsTheRobotsOwn() throws InterruptedException {
    Clock first = await(listen("/clock", RecordCodec.of(Clock.class)), any -> true);
    assertTrue(first.clock() < Duration.ofHours(1).toNanos());
    assertEquals(
        new XmlRpcValue.Bool(true), observer.parameters().get("/use_sim_time").toOptional().orElseThrow());
  }
}
