package org.robotui.entity.robotmodel.internal;

import java.util.Locale;
import org.robotui.urdf.Joint;

/** Positions of joints in words. */
final class Quantity {
  private Quantity() {}

  /** A position or a distance of a joint with its unit, to a thousandth. */
  static String of(Joint joint, double value) {
    return String.format(Locale.ROOT, "%.3f %s", value, joint.type() == Joint.Type.PRISMATIC ? "m" : "rad");
  }
}
