package org.robotui.rfic.ros2.internal.graph;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import org.robotui.message.DynamicMessage;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.ros2.Ros2Codec;

/**
 * A topic of ROS 2 on which messages of other robots are said, also by their bytes alone.
 *
 * @param topic says bytes
 * @param codec makes bytes of messages
 */
record RelayedOut(TopicOut<ByteBuffer> topic, Ros2Codec<DynamicMessage> codec)
    implements TopicPublisher<DynamicMessage> {
  @Override
  public int subscribers() {
    return topic.subscribers();
  }

  @Override
  public Optional<String> obstacle() {
    return topic.obstacle();
  }

  @Override
  public void publish(DynamicMessage message) {
    topic.publish(codec.encode(message));
  }

  @Override
  public boolean publishRaw(String encoding, ByteBuffer bytes) {
    boolean same = encoding.equals(Ros2TopicClient.ENCODING);
    if (same) {
      topic.publish(bytes);
    }
    return same;
  }

  @Override
  public void publishUrgently(DynamicMessage message) {
    topic.publishUrgently(codec.encode(message));
  }

  @Override
  public void awaitSent(Duration patience) {
    topic.awaitSent(patience);
  }

  @Override
  public void close() {
    topic.close();
  }
}
