package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
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
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.rosgraph_msgs.Log;
import org.robotui.message.ros.sensor_msgs.PointCloud2;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerFeedback;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerUpdate;
import org.robotui.message.ros.visualization_msgs.Marker;
import org.robotui.message.ros.visualization_msgs.MarkerArray;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;

/**
 * What the demo shows in space, over loopback: points, markers, and a waypoint that is moved by hand. Ten times faster
 * than real.
 */
class DemoMarkersTest {
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private Demo demo;
  private RosNode observer;

  @BeforeEach
  void start() throws IOException {
    demo = Demo.start(Options.parse(List.of("--name", "base", "--speed-factor", "10")));
    NodeOptions options = NodeOptions.standard(task -> Thread.ofPlatform().daemon().unstarted(task));
    observer = RosNode.open(RosEnvironment.of(demo.masterUri()), GraphName.of("observer"), options);
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

  private static InteractiveMarkerFeedback feedback(int event, double x, double y, int entry) {
    return new InteractiveMarkerFeedback(new Header(0, 0, "map"), "test", "waypoint", "floor", event,
        new Pose(new Point(x, y, 0), new Quaternion(0, 0, 0, 1)), entry, new Point(0, 0, 0), false);
  }

  @Test
  void aCloudOfThousandsOfPointsComesInItsFrame() throws InterruptedException {
    PointCloud2 cloud = await(listen("/lidar/points", RecordCodec.of(PointCloud2.class)), any -> true);
    assertEquals("base_lidar", cloud.header().frameId());
    assertTrue(cloud.width() > 8_000 && cloud.data().remaining() == 16 * cloud.width(), cloud.width() + " points");
  }

  @Test
  void objectsAreShownWithTheirNames() throws InterruptedException {
    MarkerArray objects = await(listen("/objects", RecordCodec.of(MarkerArray.class)), any -> true);
    assertTrue(objects.markers().stream()
        .anyMatch(m -> m.type() == Marker.TEXT_VIEW_FACING && m.text().equals("server rack")));
    Marker person = objects.markers().stream().filter(m -> m.ns().equals("people")).findFirst().orElseThrow();
    assertTrue(person.lifetime() > 0 && person.scale().z() > 1);
    assertEquals(objects.markers().size(), objects.markers().stream().map(m -> m.ns() + m.id()).distinct().count(),
        "names are unique");
  }

  @Test
  void theWaypointIsMovedAndTheRobotSentToIt() throws InterruptedException {
    BlockingQueue<Log> log = listen("/rosout", RecordCodec.of(Log.class));
    BlockingQueue<InteractiveMarkerUpdate> updates =
        listen("/waypoint/update", RecordCodec.of(InteractiveMarkerUpdate.class));
    InteractiveMarkerInit all =
        await(listen("/waypoint/update_full", RecordCodec.of(InteractiveMarkerInit.class)), any -> true);
    assertEquals("Go", all.markers().getFirst().menuEntries().getFirst().title());
    await(updates, m -> m.type() == InteractiveMarkerUpdate.KEEP_ALIVE && m.seqNum() == all.seqNum());
    Publisher<InteractiveMarkerFeedback> hand = observer.publisher("/waypoint/feedback",
        RecordCodec.of(InteractiveMarkerFeedback.class), PublisherOptions.latched());
    hand.publish(feedback(InteractiveMarkerFeedback.POSE_UPDATE, 2.6, 3.2, 0));
    InteractiveMarkerUpdate moved = await(updates, m -> m.type() == InteractiveMarkerUpdate.UPDATE);
    assertEquals(all.seqNum() + 1, moved.seqNum());
    assertEquals(3.2, moved.poses().getFirst().pose().position().y());
    hand.publish(feedback(InteractiveMarkerFeedback.POSE_UPDATE, -40, 3.2, 0));
    assertEquals(2.6, await(updates, m -> m.seqNum() == all.seqNum() + 2).poses().getFirst().pose().position().x(),
        "it stays in the building");
    hand.publish(feedback(InteractiveMarkerFeedback.MENU_SELECT, 2.6, 3.2, 1));
    await(log, entry -> entry.msg().equals("goal reached"));
  }
}
