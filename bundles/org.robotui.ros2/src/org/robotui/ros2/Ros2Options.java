package org.robotui.ros2;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.message.Definitions;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.rtps.ParticipantLimits;

/**
 * What a context is given by its owner.
 *
 * @param threads makes all threads of the context
 * @param definitions the definitions of types of this machine
 * @param limits how much memory peers may take
 * @param lease how long others take this process to be there when they do not hear it; empty for the standard
 */
public record Ros2Options(ThreadFactory threads, Definitions definitions, ParticipantLimits limits,
    Optional<Duration> lease) {

  /** Checks that nothing is missing. */
  public Ros2Options {
    Objects.requireNonNull(threads, "threads");
    Objects.requireNonNull(definitions, "definitions");
    Objects.requireNonNull(limits, "limits");
    Objects.requireNonNull(lease, "lease");
  }

  /**
   * Types that are shipped alone, standard limits.
   *
   * @param threads makes all threads of the context
   * @return the default
   */
  public static Ros2Options standard(ThreadFactory threads) {
    return new Ros2Options(threads, new LocalDefinitions(List.of(), List.of(), Generation.ROS2),
        ParticipantLimits.standard(),
        Optional.empty());
  }

  /**
   * The same options with definitions of this machine.
   *
   * @param local such as {@link LocalDefinitions#ofRos2}
   * @return the changed options
   */
  public Ros2Options withDefinitions(Definitions local) {
    return new Ros2Options(threads, local, limits, lease);
  }

  /**
   * The same options with another lease.
   *
   * @param time how long others take this process to be there when they do not hear it
   * @return the changed options
   */
  public Ros2Options withLease(Duration time) {
    return new Ros2Options(threads, definitions, limits, Optional.of(time));
  }
}
