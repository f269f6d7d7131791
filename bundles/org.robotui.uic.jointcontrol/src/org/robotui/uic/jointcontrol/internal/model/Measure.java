package org.robotui.uic.jointcontrol.internal.model;

import org.robotui.api.input.TypedText;
import org.robotui.api.input.Unreadable;
import org.robotui.data.joint.JointModel;
import org.robotui.ui.Figures;

/**
 * How figures of a joint are written and read. Pure.
 *
 * @param type what the joint does
 * @param degrees whether angles are in degrees
 */
public record Measure(JointModel.Type type, boolean degrees) {
  private static final double FINE_DEGREES = 0.5;
  private static final double FINE_RADIANS = 0.01;
  private static final double FINE_METRES = 0.001;

  private boolean slides() {
    return type == JointModel.Type.PRISMATIC;
  }

  private boolean inDegrees() {
    return degrees && !slides();
  }

  /** A position with its unit. */
  public String position(double value) {
    return inDegrees() ? Figures.degrees(value, 1) : figure(value, slides() ? 4 : 3, slides() ? "m" : "rad");
  }

  /** A velocity with its unit. */
  public String velocity(double value) {
    return inDegrees() ? figure(Math.toDegrees(value), 1, "\u00b0/s")
        : figure(value, slides() ? 4 : 3, slides() ? "m/s" : "rad/s");
  }

  /** A torque or force with its unit. */
  public String effort(double value) {
    return figure(value, 1, slides() ? "N" : "N\u00b7m");
  }

  /** A stiffness with its unit. */
  public String stiffness(double value) {
    return figure(value, 0, stiffnessUnit());
  }

  /** The unit of a stiffness. */
  public String stiffnessUnit() {
    return slides() ? "N/m" : "N\u00b7m/rad";
  }

  /** A damping with its unit. */
  public String damping(double value) {
    return figure(value, 1, dampingUnit());
  }

  /** The unit of a damping. */
  public String dampingUnit() {
    return slides() ? "N\u00b7s/m" : "N\u00b7m\u00b7s/rad";
  }

  /** How much a fine step is, radians or metres. */
  public double fine() {
    return slides() ? FINE_METRES : degrees ? Math.toRadians(FINE_DEGREES) : FINE_RADIANS;
  }

  /** The position as it stands in a field: without its unit. */
  public String typed(double value) {
    return Figures.fixed(inDegrees() ? Math.toDegrees(value) : value, inDegrees() ? 1 : slides() ? 4 : 3);
  }

  /** Reads what was typed into a field, in radians or metres; an angle may have its sign. */
  public double read(String typed) throws Unreadable {
    return inDegrees() ? Math.toRadians(TypedText.finite(typed.replace("\u00b0", ""))) : TypedText.finite(typed);
  }

  private static String figure(double value, int decimals, String unit) {
    return Double.isNaN(value) ? Figures.UNKNOWN : Figures.of(value, decimals, unit);
  }
}
