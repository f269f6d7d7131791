package org.robotui.message.topic.internal;

import java.util.function.BiConsumer;
import org.robotui.api.port.Publication;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.TopicListener;

/**
 * Takes the messages of a topic; those that cannot be read are lost to the stream that they were meant for.
 *
 * @param topic its name
 * @param stream is told what is lost
 * @param taking takes a message
 * @param <M> the Java value of a message
 */
record TopicIntake<M>(String topic, Publication<?> stream, BiConsumer<M, Arrival> taking)
    implements TopicListener<M> {
  @Override
  public void received(M message, Arrival arrival) {
    taking.accept(message, arrival);
  }

  @Override
  public void unreadable(String reason, Arrival arrival) {
    lost(stream, topic, reason, arrival);
  }

  /** Says that a message is lost, where it came from and why. */
  static void lost(Publication<?> stream, String topic, String reason, Arrival arrival) {
    stream.lost(1, topic + " from " + arrival.sender() + ": " + reason);
  }
}
