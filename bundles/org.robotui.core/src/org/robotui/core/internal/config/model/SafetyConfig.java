package org.robotui.core.internal.config.model;

import java.util.Optional;
import org.robotui.data.command.MotionLimits;

/**
 * How one robot is kept safe.
 *
 * @param limits no motion command exceeds them
 * @param stopCall what it is asked when it is stopped
 * @param leaseNeeded true where commands need the lease
 */
public record SafetyConfig(MotionLimits limits, Optional<StopCall> stopCall, boolean leaseNeeded) {
  /** Of robots of which the file says nothing: no limit, no call, but a lease. */
  public static final SafetyConfig DEFAULT = new SafetyConfig(MotionLimits.NONE, Optional.empty(), true);
}
