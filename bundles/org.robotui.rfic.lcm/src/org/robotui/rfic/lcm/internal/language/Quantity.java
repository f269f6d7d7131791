package org.robotui.rfic.lcm.internal.language;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * What a number measures, and in which units it may be sent. Without a unit it is in that of SI, the first one here.
 */
public enum Quantity {
  /** A count, an index, a share without a dimension. */
  PLAIN,
  /** A distance. */
  LENGTH("m", 1, "cm", 1e-2, "mm", 1e-3, "km", 1e3, "in", 0.0254, "ft", 0.3048),
  /** An angle. */
  ANGLE("rad", 1, "deg", Math.PI / 180, "mrad", 1e-3),
  /** A time. */
  TIME("s", 1, "ms", 1e-3, "us", 1e-6, "ns", 1e-9, "min", 60),
  /** How fast something goes. */
  SPEED("m/s", 1, "cm/s", 1e-2, "mm/s", 1e-3, "km/h", 1 / 3.6),
  /** How fast something turns. */
  TURN_RATE("rad/s", 1, "deg/s", Math.PI / 180, "rpm", Math.PI / 30),
  /** How fast something becomes faster. */
  ACCELERATION("m/s2", 1, "g", 9.80665),
  /** Electric tension. */
  VOLTAGE("V", 1, "mV", 1e-3),
  /** Electric current. */
  CURRENT("A", 1, "mA", 1e-3),
  /** A part of the whole, 0 to 1. */
  SHARE("1", 1, "%", 1e-2),
  /** A force. */
  FORCE("N", 1, "kN", 1e3),
  /** A torque. */
  TORQUE("Nm", 1),
  /** Where a joint is, whether it turns or slides. */
  JOINT("rad", 1, "deg", Math.PI / 180, "m", 1, "cm", 1e-2, "mm", 1e-3),
  /** How fast a joint moves. */
  JOINT_SPEED("rad/s", 1, "deg/s", Math.PI / 180, "rpm", Math.PI / 30, "m/s", 1, "mm/s", 1e-3),
  /** What drives a joint. */
  EFFORT("Nm", 1, "N", 1),
  /** The numbers of a quaternion in their order. */
  ROTATION("wxyz", 1, "xyzw", 1);

  private final Map<String, Double> factors = new LinkedHashMap<>();

  Quantity(Object... units) {
    for (int i = 0; i < units.length; i += 2) {
      factors.put((String) units[i], ((Number) units[i + 1]).doubleValue());
    }
  }

  /** What a number in a unit is multiplied with to be in that of SI; none for a unit of something else. */
  public Optional<Double> factor(String unit) {
    return Optional.ofNullable(factors.get(unit));
  }

  /** The units, for messages. */
  public String units() {
    return String.join(", ", factors.keySet());
  }
}
