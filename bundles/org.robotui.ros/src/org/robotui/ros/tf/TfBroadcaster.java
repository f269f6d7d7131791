package org.robotui.ros.tf;

import java.util.List;

import org.robotui.message.RecordCodec;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.tf.FrameTransform;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;

/** Sends transforms that change. Any thread may use it. */
public final class TfBroadcaster implements AutoCloseable {

  private static final int QUEUE = 100;

  private final Publisher<TFMessage> publisher;

  /**
   * Starts to publish.
   *
   * @param node publishes; the broadcaster does not close it
   * @param topics where to
   * @throws IllegalStateException if the node publishes the topic already, or is closed
   */
  public TfBroadcaster(RosNode node, TfTopics topics) {
    publisher =
        node.publisher(topics.moving(), RecordCodec.of(TFMessage.class), PublisherOptions.standard().withQueue(QUEUE));
  }

  /**
   * Sends transforms in one message.
   *
   * @param transforms the transforms
   */
  public void send(List<FrameTransform> transforms) {
    publisher.publish(new TFMessage(transforms.stream().map(FrameTransform::toMessage).toList()));
  }

  /** Ends the publication. */
  @Override
  public void close() {
    publisher.close();
  }
}
