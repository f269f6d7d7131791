package org.robotui.ros.tf;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;

import org.robotui.geometry.TransformBuffer;
import org.robotui.geometry.TransformPut;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.ros.Reception;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;

/**
 * Fills a buffer with the transforms that all publishers send, of type {@code tf2_msgs/TFMessage} or the old
 * {@code tf/tfMessage}, which is the same on the wire. When simulated time jumps back, the moving transforms are
 * forgotten.
 */
public final class TfListener implements AutoCloseable {

  private final TransformBuffer<String> buffer;
  private final Consumer<TfRefusal> refusals;
  private final AtomicLong refused = new AtomicLong();
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
    this.buffer = buffer;
    this.refusals = refusals;
    jumps = node.clock().onJumpBack((from, to) -> buffer.clear());
    moving = node.subscriber(topics.moving(), RecordCodec.of(TFMessage.class), SubscriberOptions.standard(),
        (message, reception) -> take(message, reception, topics.moving(), this::put));
    fixed = node.subscriber(topics.fixed(), RecordCodec.of(TFMessage.class), SubscriberOptions.standard(),
        (message, reception) -> take(message, reception, topics.fixed(), this::putStatic));
  }

  /** Stores one transform of a publisher. */
  @FunctionalInterface
  private interface Store {
    TransformPut<String> put(FrameTransform transform, String authority);
  }

  private void take(TFMessage message, Reception reception, String topic, Store store) {
    for (TransformStamped each : message.transforms()) {
      problem(FrameTransform.of(each), reception.callerId(), store).ifPresent(reason -> {
        refused.incrementAndGet();
        refusals.accept(new TfRefusal(topic, reception.callerId(), reason));
      });
    }
  }

  private static Optional<String> problem(FrameTransform transform, String callerId, Store store) {
    if (transform.parent().isEmpty() || transform.child().isEmpty()) {
      return Optional.of("the transform '" + transform.parent() + "' -> '" + transform.child()
          + "' has a frame without a name");
    }
    return store.put(transform, callerId) instanceof TransformPut.Refused<String> no
        ? Optional.of(no.reason())
        : Optional.empty();
  }

  private TransformPut<String> put(FrameTransform t, String authority) {
    return buffer.put(t.parent(), t.child(), t.stampNanos(), t.parentFromChild(), authority);
  }

  private TransformPut<String> putStatic(FrameTransform t, String authority) {
    return buffer.putStatic(t.parent(), t.child(), t.parentFromChild(), authority);
  }

  /**
   * How many transforms were not taken over.
   *
   * @return the number so far
   */
  public long refused() {
    return refused.get();
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
