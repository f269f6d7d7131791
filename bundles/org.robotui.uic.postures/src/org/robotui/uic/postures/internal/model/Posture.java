package org.robotui.uic.postures.internal.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Where joints are to be.
 *
 * @param name as the user calls it
 * @param seconds that the way to it takes, at least
 * @param joints positions by joint, radians or metres; others stay where they are
 */
public record Posture(String name, double seconds, Map<String, Double> joints) {
  /** The shortest way, seconds. */
  public static final double SHORTEST = 0.1;
  /** The longest way, seconds. */
  public static final double LONGEST = 3600;

  private static final double DIGITS = 1e5;

  /** Copies the map, in its order. */
  public Posture {
    joints = Collections.unmodifiableMap(new LinkedHashMap<>(joints));
  }

  Posture named(String other) {
    return new Posture(other, seconds, joints);
  }

  Posture within(double time) {
    return new Posture(name, time, joints);
  }

  Posture at(Map<String, Double> positions) {
    return new Posture(name, seconds, positions);
  }

  /** As a configuration has it: to a hundredth of a milliradian, which no joint measures. */
  Map<String, Object> fields() {
    Map<String, Object> written = new LinkedHashMap<>();
    joints.forEach((joint, position) -> written.put(joint, Math.rint(position * DIGITS) / DIGITS));
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put(PostureSequence.NAME, name);
    fields.put(PostureSequence.SECONDS, seconds);
    fields.put(PostureSequence.JOINTS, written);
    return fields;
  }
}
