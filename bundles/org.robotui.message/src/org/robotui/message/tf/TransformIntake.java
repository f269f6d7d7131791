package org.robotui.message.tf;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.robotui.geometry.TransformBuffer;
import org.robotui.geometry.TransformPut;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.tf2_msgs.TFMessage;

/** Fills a buffer with the transforms of messages, and counts those that it does not take over. Any thread may call. */
public final class TransformIntake {
  private final TransformBuffer<String> buffer;
  private final AtomicLong refused = new AtomicLong();

  /**
   * An intake that has refused nothing.
   *
   * @param buffer is filled, its frames named without leading slash
   */
  public TransformIntake(TransformBuffer<String> buffer) {
    this.buffer = buffer;
  }

  /** Stores one transform of a sender. */
  @FunctionalInterface
  private interface Store {
    TransformPut<String> put(FrameTransform transform);
  }

  /**
   * Takes transforms that hold for the time of their stamp.
   *
   * @param message of {@code /tf}
   * @param authority who sent it, as the buffer names who contradicts whom
   * @param refusals hears why a transform was not taken over, in a sentence; called on this thread
   */
  public void moving(TFMessage message, String authority, Consumer<String> refusals) {
    take(message, t -> buffer.put(t.parent(), t.child(), t.stampNanos(), t.parentFromChild(), authority), refusals);
  }

  /**
   * Takes transforms that hold for all times.
   *
   * @param message of {@code /tf_static}
   * @param authority who sent it, as the buffer names who contradicts whom
   * @param refusals hears why a transform was not taken over, in a sentence; called on this thread
   */
  public void fixed(TFMessage message, String authority, Consumer<String> refusals) {
    take(message, t -> buffer.putStatic(t.parent(), t.child(), t.parentFromChild(), authority), refusals);
  }

  private void take(TFMessage message, Store store, Consumer<String> refusals) {
    for (TransformStamped each : message.transforms()) {
      problem(FrameTransform.of(each), store).ifPresent(reason -> {
        refused.incrementAndGet();
        refusals.accept(reason);
      });
    }
  }

  private static Optional<String> problem(FrameTransform transform, Store store) {
    if (transform.parent().isEmpty() || transform.child().isEmpty()) {
      return Optional.of("the transform '" + transform.parent() + "' -> '" + transform.child()
          + "' has a frame without a name");
    }
    return store.put(transform) instanceof TransformPut.Refused<String> no ? Optional.of(no.reason())
        : Optional.empty();
  }

  /**
   * How many transforms were not taken over.
   *
   * @return the number so far
   */
  public long refused() {
    return refused.get();
  }
}
