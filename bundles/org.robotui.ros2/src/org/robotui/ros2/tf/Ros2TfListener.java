package org.robotui.ros2.tf;

import java.util.function.BiConsumer;
import org.robotui.geometry.TransformBuffer;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.tf.TransformIntake;
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

  private final TransformIntake intake;
  private final Ros2Subscriber moving;
  private final Ros2Subscriber fixed;
  private final AutoCloseable jumps;

  /**
   * Starts to listen to {@code /tf} and {@code /tf_static}.
   *
   * @param node subscribes; the listener does not close it
   * @param buffer is filled, its frames named without leading slash
   * @param refusals hears of each transform that was not taken over: where it came from, and why it was not; called on
   * the receiving thread, must not block
   */
  public Ros2TfListener(Ros2Node node, TransformBuffer<String> buffer, BiConsumer<Ros2Reception, String> refusals) {
    intake = new TransformIntake(buffer);
    Ros2Codec<TFMessage> codec = Ros2Codec.of(TFMessage.class);
    jumps = node.clock().onJumpBack((from, to) -> buffer.clear());
    moving = node.subscriber("/tf", codec, new Ros2SubscriberOptions(QosProfiles.TF, true),
        (message, from) -> intake.moving(message, from.from(), reason -> refusals.accept(from, reason)));
    fixed = node.subscriber("/tf_static", codec,
        new Ros2SubscriberOptions(QosProfiles.TF_STATIC.withDepth(QosProfiles.TF.depth()), true),
        (message, from) -> intake.fixed(message, from.from(), reason -> refusals.accept(from, reason)));
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
