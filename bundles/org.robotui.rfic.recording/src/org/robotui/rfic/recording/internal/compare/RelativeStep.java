package org.robotui.rfic.recording.internal.compare;

import java.util.ArrayList;
import java.util.List;
import org.robotui.geometry.RigidTransform;

/**
 * Over which part of the way relative errors are taken.
 *
 * @param length a number of poses, or metres
 * @param metres which of both
 */
public record RelativeStep(double length, boolean metres) {
  /** From each pose to the next one. */
  public static final RelativeStep POSE = new RelativeStep(1, false);

  /**
   * Checks it.
   *
   * @param length above 0; a whole number of poses
   * @param metres likewise
   */
  public RelativeStep {
    if (!(length > 0) || !Double.isFinite(length) || !metres && length != Math.rint(length)) {
      throw new IllegalArgumentException(
          "relative errors are taken over a whole number of poses such as 10, or metres such as 0.5m");
    }
  }

  /**
   * Reads it.
   *
   * @param word such as {@code 10} or {@code 0.5m}
   * @return the step
   */
  public static RelativeStep of(String word) {
    boolean metres = word.endsWith("m");
    try {
      return new RelativeStep(Double.parseDouble(metres ? word.substring(0, word.length() - 1) : word), metres);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("'" + word + "' is neither a number of poses such as 10 nor metres such as"
          + " 0.5m", e);
    }
  }

  /** As users read it. */
  @Override
  public String toString() {
    String number = length == Math.rint(length) ? Long.toString((long) length) : Double.toString(length);
    return metres ? number + " m" : length == 1 ? "pose" : number + " poses";
  }

  /** The poses at which steps begin and end, one step behind the other. */
  List<Integer> places(List<RigidTransform> way) {
    List<Integer> places = new ArrayList<>();
    double gone = 0;
    for (int i = 0; i < way.size(); i++) {
      gone += i == 0 ? 0 : metres ? way.get(i).translation().minus(way.get(i - 1).translation()).norm() : 1;
      if (i == 0 || gone >= length) {
        places.add(i);
        gone = 0;
      }
    }
    return places;
  }
}
