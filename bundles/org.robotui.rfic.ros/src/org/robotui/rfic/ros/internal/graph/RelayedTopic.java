package org.robotui.rfic.ros.internal.graph;

import java.nio.ByteBuffer;
import java.time.Duration;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageInfo;
import org.robotui.message.RawMessage;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.ros.Publisher;

/**
 * A topic of ROS 1 on which messages of other robots are said, also by their bytes alone.
 *
 * @param publisher says them
 * @param type of the messages
 */
record RelayedTopic(Publisher<RawMessage> publisher, MessageInfo type) implements TopicPublisher<DynamicMessage> {
  @Override
  public int subscribers() {
    return publisher.numSubscribers();
  }

  @Override
  public void publish(DynamicMessage message) {
    publisher.publish(raw(message.bytes()));
  }

  @Override
  public boolean publishRaw(String encoding, ByteBuffer bytes) {
    boolean same = encoding.equals(RosTopicClient.ENCODING);
    if (same) {
      publisher.publish(raw(bytes));
    }
    return same;
  }

  @Override
  public void publishUrgently(DynamicMessage message) {
    publisher.publishUrgently(raw(message.bytes()));
  }

  private RawMessage raw(ByteBuffer bytes) {
    return new RawMessage(type, bytes);
  }

  @Override
  public void awaitSent(Duration patience) {
    publisher.awaitSent(patience);
  }

  @Override
  public void close() {
    publisher.close();
  }
}
