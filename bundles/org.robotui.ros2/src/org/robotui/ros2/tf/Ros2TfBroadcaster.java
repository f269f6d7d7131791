package org.robotui.ros2.tf;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Publisher;

/**
 * Sends transforms, those that change and those that hold for all times. Each message of the latter carries all that
 * were sent so far, because late subscribers get the last message only. Any thread may use it.
 */
public final class Ros2TfBroadcaster implements AutoCloseable {

  private final Ros2Publisher<TFMessage> moving;
  private final Ros2Publisher<TFMessage> fixed;
  private final Map<String, TransformStamped> byChild = new LinkedHashMap<>();

  /**
   * Starts to publish {@code /tf} and {@code /tf_static}.
   *
   * @param node publishes; the broadcaster does not close it
   */
  public Ros2TfBroadcaster(Ros2Node node) {
    Ros2Codec<TFMessage> codec = Ros2Codec.of(TFMessage.class);
    moving = node.publisher("/tf", codec, QosProfiles.TF);
    fixed = node.publisher("/tf_static", codec, QosProfiles.TF_STATIC);
  }

  /**
   * Sends transforms in one message.
   *
   * @param transforms where frames are now
   */
  public void send(List<TransformStamped> transforms) {
    moving.publish(new TFMessage(transforms));
  }

  /**
   * Adds transforms that hold for all times, or replaces those of the same child frames.
   *
   * @param transforms where frames are
   */
  public void sendStatic(List<TransformStamped> transforms) {
    synchronized (byChild) {
      transforms.forEach(each -> byChild.put(each.childFrameId(), each));
      fixed.publish(new TFMessage(List.copyOf(byChild.values())));
    }
  }

  /** Ends both publications. */
  @Override
  public void close() {
    moving.close();
    fixed.close();
  }
}
