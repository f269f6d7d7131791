package org.robotui.ros2;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.TransformBuffer;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.ros2.tf.Ros2TfBroadcaster;
import org.robotui.ros2.tf.Ros2TfListener;

/** Transforms from one node to the buffer of another. */
class TfTest {

  private final FakeDomain domain = new FakeDomain();

  @AfterEach
  void close() {
    domain.close();
  }

  private static TransformStamped at(String parent, String child, double x) {
    return new TransformStamped(new Header(0, 1_000_000_000L, parent), child,
        new Transform(new Vector3(x, 0, 0), new Quaternion(0, 0, 0, 1)));
  }

  @Test
  void transformsFillABufferAndWrongOnesAreRefusedWithTheReason() {
    Ros2TfBroadcaster broadcaster = new Ros2TfBroadcaster(domain.context().node("base"));
    TransformBuffer<String> buffer = new TransformBuffer<>();
    List<String> refusals = new CopyOnWriteArrayList<>();
    Ros2TfListener listener =
        new Ros2TfListener(domain.context().node("view"), buffer, (from, reason) -> refusals.add(reason));
    Eventually.await("both topics", () -> listener.numPublishers() == 2);
    broadcaster.sendStatic(List.of(at("base_link", "laser", 0.5)));
    broadcaster.sendStatic(List.of(at("base_link", "camera", 0.7)));
    broadcaster.send(List.of(at("odom", "base_link", 2), at("", "nothing", 0)));
    Eventually.await("all frames", () -> buffer.frames().containsAll(List.of("odom", "base_link", "laser")));
    Eventually.await("the refusal", () -> listener.refused() == 1);
    assertEquals(List.of("the transform '' -> 'nothing' has a frame without a name"), refusals);
    listener.close();
  }
}
