package org.robotui.ros.tf;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.tf.FrameTransform;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformBuffer;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.tf.TfMessage;
import org.robotui.ros.Eventually;
import org.robotui.ros.Graph;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;

/** Transforms between nodes, ours and those of rospy. */
class TfOverTheWireTest {

  private static final Path PYTHON = Path.of("/usr/bin/python3");
  private static final String ROSPY = """
      import rospy
      from tf2_msgs.msg import TFMessage
      from geometry_msgs.msg import TransformStamped
      def transform(parent, child, secs):
          t = TransformStamped()
          t.header.frame_id, t.child_frame_id, t.header.stamp = parent, child, rospy.Time(secs)
          t.transform.translation.x, t.transform.rotation.w = 2.0, 1.0
          return t
      rospy.init_node('python')
      fixed = rospy.Publisher('/tf_static', TFMessage, latch=True, queue_size=1)
      fixed.publish([transform('base', 'lidar', 0)])
      moving = rospy.Publisher('/tf', TFMessage, queue_size=10)
      rate = rospy.Rate(50)
      while not rospy.is_shutdown():
          moving.publish([transform('/odom', '/base', 7)])
          rate.sleep()
      """;

  private final TransformBuffer<String> buffer = new TransformBuffer<>();
  private final List<TfRefusal> refusals = new CopyOnWriteArrayList<>();
  private Graph graph;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
  }

  @AfterEach
  void stop() {
    graph.close();
  }

  private TfListener listen() throws Exception {
    return new TfListener(graph.node("listener"), TfTopics.STANDARD, buffer, refusals::add);
  }

  private static FrameTransform ahead(String parent, String child) {
    return new FrameTransform(parent, child, 1_000_000_000L, RigidTransform.planar(1, 0, 0));
  }

  @Test
  void aLateListenerGetsTheStaticTransformsOfAllNodes() throws Exception {
    try (StaticTfBroadcaster one = new StaticTfBroadcaster(graph.node("one"), TfTopics.STANDARD);
        StaticTfBroadcaster two = new StaticTfBroadcaster(graph.node("two"), TfTopics.STANDARD)) {
      one.send(List.of(ahead("base", "laser")));
      one.send(List.of(ahead("base", "camera")));
      two.send(List.of(ahead("camera", "lens")));
      try (TfListener listener = listen()) {
        Eventually.await("all frames", () -> buffer.frames().equals(Set.of("base", "laser", "camera", "lens")));
        assertEquals(0, listener.refused());
      }
    }
  }

  @Test
  void theOldMessageTypeIsUnderstood() throws Exception {
    RosNode old = graph.node("old");
    Publisher<TfMessage> publisher = old.publisher("/tf", RecordCodec.of(TfMessage.class), PublisherOptions.latched());
    publisher.publish(new TfMessage(List.of(ahead("/odom", "/base").toMessage())));
    try (TfListener listener = listen();
        TfBroadcaster other = new TfBroadcaster(graph.node("new"), TfTopics.STANDARD)) {
      Eventually.await("both publishers", () -> listener.numPublishers() == 2);
      // Sent again and again: the publisher may meet the listener later than the listener meets the publisher.
      Eventually.await("both transforms", () -> {
        other.send(List.of(ahead("map", "odom")));
        return buffer.frames().equals(Set.of("map", "odom", "base"));
      });
    }
  }

  @Test
  void transformsOfARospyNodeJoinOurs() throws Exception {
    Assumptions.assumeTrue(Files.isExecutable(PYTHON) && run("import rospy, tf2_msgs.msg").waitFor() == 0, "no rospy");
    Process rospy = run(ROSPY);
    try (TfListener listener = listen();
        StaticTfBroadcaster ours = new StaticTfBroadcaster(graph.node("ours"), TfTopics.STANDARD)) {
      ours.send(List.of(ahead("lidar", "window")));
      Eventually.await("the whole chain",
          () -> buffer.lookup("odom", "window", 7_000_000_000L).transform().isPresent());
      RigidTransform odomFromWindow = buffer.lookup("odom", "window", 7_000_000_000L).transform().orElseThrow();
      assertEquals(5, odomFromWindow.translation().x(), 1e-12);
      assertEquals(List.of(), refusals);
    } finally {
      rospy.destroy();
      rospy.waitFor(5, TimeUnit.SECONDS);
    }
  }

  private Process run(String script) throws Exception {
    ProcessBuilder python = new ProcessBuilder(PYTHON.toString(), "-c", script)
        .redirectError(ProcessBuilder.Redirect.DISCARD).redirectOutput(ProcessBuilder.Redirect.DISCARD);
    python.environment().put("ROS_MASTER_URI", graph.master().uri().toString());
    python.environment().put("ROS_IP", "127.0.0.1");
    return python.start();
  }
}
