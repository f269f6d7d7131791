package org.robotui.uic.jointcontrol.internal.model;

/** How far the user is with driving joints. */
public enum Phase {
  /** Nothing is commanded. */
  MONITOR,
  /** The user is asked whether to drive. */
  ASKING,
  /** What the user does moves joints. */
  DRIVING
}
