package org.robotui.data.joint;

import java.util.EnumSet;
import java.util.Set;

/** What a joint is told to keep. Several together make for example an impedance: stiffness and damping. */
public enum JointMode {
  /** A position. */
  POSITION,
  /** A velocity. */
  VELOCITY,
  /** A torque or force. */
  EFFORT,
  /** How stiffly it keeps its position. */
  STIFFNESS,
  /** How much it damps its motion. */
  DAMPING;

  /**
   * The modes in a set of bits, the lowest for {@link #POSITION}.
   *
   * @param bits bits 0 to 4; others are ignored
   * @return the modes
   */
  public static Set<JointMode> ofBits(int bits) {
    Set<JointMode> modes = EnumSet.noneOf(JointMode.class);
    for (JointMode mode : values()) {
      if ((bits & mode.bit()) != 0) {
        modes.add(mode);
      }
    }
    return modes;
  }

  /**
   * Its place in a set of bits.
   *
   * @return a power of two
   */
  public int bit() {
    return 1 << ordinal();
  }
}
