package org.robotui.ros2.tf;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiConsumer;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformBuffer;
import org.robotui.geometry.TransformPut;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Reception;
import org.robotui.ros2.Ros2Subscriber;
import org.robotui.ros2.Ros2SubscriberOptions;

/**
 * Fills a buffer with the transforms that all publishers send. When simulated time jumps back, the moving transforms
 * are forgotten.
 */
public final class Ros2TfListener implements AutoCloseable {

  private final TransformBuffer<String> buffer;
  private final BiConsumer<Ros2Reception, String> refusals;
  private final AtomicLong refused = new AtomicLong();
  private final Ros2Subscriber moving;
  private final Ros2Subscriber fixed;
  private final AutoCloseable jumps;

  /**
   * Starts to listen to {@code /tf} and {@code /tf_static}.
   *
   * @param node subscribes; the listener does not close it
   * @param buffer is filled
   * @param refusals hears of each transform that was not taken over: where it came from, and why it was not; called on
   * the receiving thread, must not block
   */
  public Ros2TfListener(Ros2Node node, TransformBuffer<String> buffer, BiConsumer<Ros2Reception, String> refusals) {
    this.buffer = buffer;
    this.refusals = refusals;
    Ros2Codec<TFMessage> codec = Ros2Codec.of(TFMessage.class);
    jumps = node.clock().onJumpBack((from, to) -> buffer.clear());
    moving = node.subscriber("/tf", codec, new Ros2SubscriberOptions(QosProfiles.TF, true),
        (message, from) -> take(message, from, this::put));
    fixed = node.subscriber("/tf_static", codec,
        new Ros2SubscriberOptions(QosProfiles.TF_STATIC.withDepth(QosProfiles.TF.depth()), true),
        (message, from) -> take(message, from, this::putStatic));
  }

  /** Stores one transform of a publisher. */
  @FunctionalInterface
  private interface Store {
    TransformPut<String> put(TransformStamped transform, String authority);
  }

  private void take(TFMessage message, Ros2Reception from, Store store) {
    for (TransformStamped each : message.transforms()) {
      problem(each, from.from(), store).ifPresent(reason -> {
        refused.incrementAndGet();
        refusals.accept(from, reason);
      });
    }
  }

  private static Optional<String> problem(TransformStamped transform, String authority, Store store) {
    String parent = transform.header().frameId();
    String child = transform.childFrameId();
    if (parent.isEmpty() || child.isEmpty()) {
      return Optional.of("the transform '" + parent + "' -> '" + child + "' has a frame without a name");
    }
    return store.put(transform, authority) instanceof TransformPut.Refused<String> no ? Optional.of(no.reason())
        : Optional.empty();
  }

  private TransformPut<String> put(TransformStamped t, String authority) {
    return buffer.put(t.header().frameId(), t.childFrameId(), t.header().stamp(), rigid(t.transform()), authority);
  }

  private TransformPut<String> putStatic(TransformStamped t, String authority) {
    return buffer.putStatic(t.header().frameId(), t.childFrameId(), rigid(t.transform()), authority);
  }

  private static RigidTransform rigid(Transform message) {
    var t = message.translation();
    var r = message.rotation();
    return new RigidTransform(new Vector3(t.x(), t.y(), t.z()), new Quaternion(r.x(), r.y(), r.z(), r.w()));
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
   * How many publishers are heard.
   *
   * @return those of both topics
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
