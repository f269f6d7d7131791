package org.robotui.ros2;

import java.util.Objects;
import org.robotui.rtps.Qos;

/**
 * How a subscriber receives.
 *
 * @param qos what is requested
 * @param adapting whether less is requested where publishers offer less, so that they are heard
 */
public record Ros2SubscriberOptions(Qos qos, boolean adapting) {

  /** Checks that nothing is missing. */
  public Ros2SubscriberOptions {
    Objects.requireNonNull(qos, "qos");
  }

  /**
   * As much as every publisher offers, up to reliable and kept for late subscribers.
   *
   * @return the options for who wants to hear whatever there is
   */
  public static Ros2SubscriberOptions observing() {
    return new Ros2SubscriberOptions(QosProfiles.LATCHED.withDepth(QosProfiles.DEFAULT.depth()), true);
  }

  /**
   * Exactly what is said.
   *
   * @param qos what is requested
   * @return the options
   */
  public static Ros2SubscriberOptions of(Qos qos) {
    return new Ros2SubscriberOptions(qos, false);
  }
}
