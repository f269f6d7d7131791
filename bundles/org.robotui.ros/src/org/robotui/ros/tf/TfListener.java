package org.robotui.ros.tf;

import java.util.function.Consumer;
import org.robotui.geometry.TransformBuffer;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.tf.TransformIntake;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;

/**
 * Fills a buffer with the transforms that all publishers send, of type {@code tf2_msgs/TFMessage} or the old
 * {@code tf/tfMessage}, which is the same on the wire. When simulated time jumps back, the moving transforms are
 * forgotten.
 */
public final class TfListener implements AutoCloseable {

  private final TransformIntake intake;
  private final Subscriber moving;
  private final Subscriber fixed;
  private final AutoCloseable jumps;

  /**
   * Starts to listen.
   *
   * @param node subscribes; the listener does not close it
   * @param topics where to listen
   * @param buffer is filled, its frames named without leading slash
   * @param refusals hears of each transform that was not taken over; called on an I/O thread, must not block
   */
  public TfListener(
      RosNode node, TfTopics topics, TransformBuffer<String> buffer, Consumer<TfRefusal> refusals) {
    intake = new TransformIntake(buffer);
    jumps = node.clock().onJumpBack((from, to) -> buffer.clear());
    moving = node.subscriber(topics.moving(), RecordCodec.of(TFMessage.class), SubscriberOptions.standard(),
        (message, from) -> intake.moving(message, from.callerId(),
            reason -> refusals.accept(new TfRefusal(topics.moving(), from.callerId(), reason))));
    fixed = node.subscriber(topics.fixed(), RecordCodec.of(TFMessage.class), SubscriberOptions.standard(),
        (message, from) -> intake.fixed(message, from.callerId(),
            reason -> refusals.accept(new TfRefusal(topics.fixed(), from.callerId(), reason))));
  }

  /**
   * How many transforms were not taken over.
   *
   * @return the number so far
   */
  public long refused() {
    return intake.refused();
  }

  /**
   * How many nodes are connected.
   *
   * @return publishers of both topics
   */
  public int numPublishers() {
    return moving.numPublishers() + fixed.numPublishers();
  }

  /** Ends both subscriptions; the buffer keeps what it has. */
  @Override
  public void close() {
    moving.close();
    fixed.close();
    try {
      jumps.close();
    } catch (Exception e) {
      throw new IllegalStateException("the clock's listener cannot be removed", e);
    }
  }
}
