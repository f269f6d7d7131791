package org.robotui.entity.robotmodel.internal;

import java.util.Map;
import java.util.Optional;
import org.robotui.urdf.Joint;

/**
 * How far joints were from their plan at most, each from the place of the plan that is nearest to all of them. Time
 * does not count, as plans are executed later or more slowly than they say.
 */
final class Deviation {
  private final Plan plan;
  private final double[] greatest;
  private boolean measured;

  Deviation(Plan plan) {
    this.plan = plan;
    greatest = new double[plan.joints().size()];
  }

  /**
   * A joint that was away.
   *
   * @param joint which
   * @param distance radians or metres, not negative
   */
  record Away(Joint joint, double distance) {
    /** The distance with its unit. */
    String words() {
      return Quantity.of(joint, distance);
    }
  }

  /** Takes where the joints are; nothing is known as long as one of the plan is missing. */
  void take(Map<String, Double> positions) {
    int count = greatest.length;
    double[] at = new double[count];
    for (int i = 0; i < count; i++) {
      at[i] = positions.getOrDefault(plan.joints().get(i).name(), Double.NaN);
      if (Double.isNaN(at[i])) {
        return;
      }
    }
    measured = true;
    double[] nearest = nearest(at);
    for (int i = 0; i < count; i++) {
      greatest[i] = Math.max(greatest[i], Math.abs(nearest[i]));
    }
  }

  /** The greatest distance of a joint of the plan since the beginning. */
  Optional<Away> of(int joint) {
    return measured ? Optional.of(new Away(plan.joints().get(joint), greatest[joint])) : Optional.empty();
  }

  /** The joint that was farthest away; radians and metres count alike. */
  Optional<Away> farthest() {
    int worst = 0;
    for (int i = 1; i < greatest.length; i++) {
      worst = greatest[i] > greatest[worst] ? i : worst;
    }
    return of(worst);
  }

  /** By joint, from the nearest place on the way between two points. */
  private double[] nearest(double[] at) {
    double[] best = away(at, 0, 0, 0);
    double least = square(best);
    for (int point = 1; point < plan.points(); point++) {
      double[] away = away(at, point - 1, point, share(at, point - 1, point));
      double square = square(away);
      if (square < least) {
        least = square;
        best = away;
      }
    }
    return best;
  }

  /** Where the foot of the perpendicular on the way between two points is, 0 to 1. */
  private double share(double[] at, int from, int to) {
    double along = 0;
    double length = 0;
    for (int i = 0; i < at.length; i++) {
      double step = plan.position(to, i) - plan.position(from, i);
      along += step * turned(i, at[i] - plan.position(from, i));
      length += step * step;
    }
    return length > 0 ? Math.clamp(along / length, 0, 1) : 0;
  }

  private double[] away(double[] at, int from, int to, double share) {
    double[] away = new double[at.length];
    for (int i = 0; i < at.length; i++) {
      double start = plan.position(from, i);
      away[i] = turned(i, at[i] - start - share * (plan.position(to, i) - start));
    }
    return away;
  }

  /** A joint without an end is where it was after a whole turn. */
  private double turned(int joint, double difference) {
    return plan.joints().get(joint).type() == Joint.Type.CONTINUOUS ? Math.IEEEremainder(difference, 2 * Math.PI)
        : difference;
  }

  private static double square(double[] away) {
    double sum = 0;
    for (double one : away) {
      sum += one * one;
    }
    return sum;
  }
}
