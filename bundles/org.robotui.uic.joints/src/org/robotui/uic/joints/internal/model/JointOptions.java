package org.robotui.uic.joints.internal.model;

import java.util.Map;
import java.util.Optional;

/**
 * What is configured.
 *
 * @param degrees whether angles are shown in degrees
 * @param units by joint
 * @param limits by joint
 */
public record JointOptions(boolean degrees, Map<String, JointUnit> units, Map<String, Span> limits) {
  /** Nothing is configured. */
  public static final JointOptions NONE = new JointOptions(false, Map.of(), Map.of());

  /** Copies the maps. */
  public JointOptions {
    units = Map.copyOf(units);
    limits = Map.copyOf(limits);
  }

  /** The unit of a joint. */
  public JointUnit unit(String joint) {
    return units.getOrDefault(joint, JointUnit.UNKNOWN);
  }

  /** The limits of a joint, where they are configured. */
  public Optional<Span> limits(String joint) {
    return Optional.ofNullable(limits.get(joint));
  }
}
