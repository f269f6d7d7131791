package org.robotui.ros.tf;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

import org.robotui.message.RecordCodec;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.tf.FrameTransform;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;

/**
 * Sends transforms that hold for all times. Each message carries all transforms sent so far, because a latched topic
 * gives late subscribers the last message only. Any thread may use it.
 */
public final class StaticTfBroadcaster implements AutoCloseable {

  private final Publisher<TFMessage> publisher;
  private final Map<String, FrameTransform> byChild = new LinkedHashMap<>();

  /**
   * Starts to publish.
   *
   * @param node publishes; the broadcaster does not close it
   * @param topics where to
   * @throws IllegalStateException if the node publishes the topic already, or is closed
   */
  public StaticTfBroadcaster(RosNode node, TfTopics topics) {
    publisher = node.publisher(topics.fixed(), RecordCodec.of(TFMessage.class), PublisherOptions.latched());
  }

  /**
   * Adds transforms, or replaces those of the same child frames.
   *
   * @param transforms the transforms
   */
  public void send(List<FrameTransform> transforms) {
    synchronized (byChild) {
      transforms.forEach(t -> byChild.put(t.child(), t));
      publisher.publish(new TFMessage(byChild.values().stream().map(FrameTransform::toMessage).toList()));
    }
  }

  /** Ends the publication. */
  @Override
  public void close() {
    publisher.close();
  }
}
