package org.robotui.uic.jointcontrol.internal.model;

import org.robotui.data.joint.JointModel;

/**
 * From where to where the bar of a joint goes. A joint without a limit has an end that is open, not a limit.
 *
 * @param lower the left end, radians or metres
 * @param upper the right end
 * @param limited whether both are limits of the joint
 */
public record Span(double lower, double upper, boolean limited) {
  private static final double OPEN_METRES = 1;
  private static final double NEAR = 0.01;

  /** The span of a joint. */
  public static Span of(JointModel.Joint joint) {
    double open = joint.type() == JointModel.Type.PRISMATIC ? OPEN_METRES : Math.PI;
    boolean limited = Double.isFinite(joint.lower()) && Double.isFinite(joint.upper()) && joint.upper() > joint.lower();
    return limited ? new Span(joint.lower(), joint.upper(), true) : new Span(-open, open, false);
  }

  /** Where a position lies, 0 to 1; NaN where it is not known. */
  public double share(double position) {
    return Double.isNaN(position) ? Double.NaN : Math.clamp((position - lower) / (upper - lower), 0.0, 1.0);
  }

  /** The position at a share. */
  public double at(double share) {
    return lower + Math.clamp(share, 0.0, 1.0) * (upper - lower);
  }

  /** Where the bar begins: at zero, or at the end that is nearest to zero. */
  public double origin() {
    return share(0);
  }

  /** The nearest position that is allowed. */
  public double within(double position) {
    return limited ? Math.clamp(position, lower, upper) : position;
  }

  /** Whether a position is at a limit or beyond it. */
  public boolean isAtLimit(double position) {
    double margin = NEAR * (upper - lower);
    return limited && (position <= lower + margin || position >= upper - margin);
  }
}
