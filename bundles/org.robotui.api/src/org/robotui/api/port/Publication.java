package org.robotui.api.port;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.Data;
import org.robotui.data.Stamp;

/**
 * The robot interface's end of a stream.
 *
 * @param <T> the type of the data
 */
public interface Publication<T extends Data> extends Offer {
  /**
   * Publishes a value received just now. Called on any I/O thread; never blocks.
   *
   * @param value the value
   * @param stamp when it was measured
   */
  default void publish(T value, Optional<Stamp> stamp) {
    publish(value, stamp, System.nanoTime(), Optional.empty());
  }

  /**
   * Publishes a value. Called on any I/O thread; never blocks. After closing it does nothing.
   *
   * @param value the value
   * @param stamp when it was measured
   * @param receivedNanos when its bytes were received, {@link System#nanoTime()}
   * @param raw the message as it came
   */
  void publish(T value, Optional<Stamp> stamp, long receivedNanos, Optional<RawMessage> raw);

  /**
   * Counts messages that were lost or could not be decoded before they became values.
   *
   * @param count how many
   * @param reason a sentence for users, naming peer and cause
   */
  void lost(long count, String reason);

  /**
   * Says whether the sender keeps its last value for those who ask later, as ROS publishers that latch. Such a value
   * holds until the next one comes and is not stale by its age, unless values come more than once a second. Called on
   * any I/O thread; without a call they are not kept.
   *
   * @param forLateComers true where the last one is kept
   */
  default void kept(boolean forLateComers) {}

  /**
   * Says that what was published so far counts no more, as if nothing had come yet: a recording was moved to a time
   * before it. Never blocks.
   */
  default void forget() {}

  /**
   * Says what the robot's software promises of the delivery of this stream, such as the quality of service of its
   * publishers. Called on any thread, as often as it is looked at.
   *
   * @param promise a sentence for users; empty where nothing is said
   */
  default void delivery(String promise) {}

  /**
   * Says that the values of this stream are messages of the robot, of which some hold until they are replaced, so that
   * whoever records is given them first. Called once, before anything is published.
   *
   * @param messages gives those that hold now, on any thread
   */
  default void held(Supplier<List<RawMessage>> messages) {}

  /**
   * Says that the robot is a recording, all of which can be read at any time. Called at most once, before anything is
   * published; without a call a stream has no history, as those of live robots.
   *
   * @param all reads this stream by the name of its port
   */
  default void history(StreamHistory all) {}

  /**
   * Says that the source as such does not work although the link may; cleared by the next value, or by an empty reason.
   *
   * @param reason a sentence for users; empty where it works again
   */
  void failed(String reason);
}
