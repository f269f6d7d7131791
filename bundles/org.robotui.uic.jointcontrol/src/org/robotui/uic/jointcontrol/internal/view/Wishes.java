package org.robotui.uic.jointcontrol.internal.view;

/** What the user sets in the view, kept with its settings. Display thread, but for the questions. */
public interface Wishes {
  /** Whether angles are in degrees. */
  boolean degrees();

  /** Has angles in degrees or not. */
  void degrees(boolean wanted);

  /** The share of their speed at which joints move at most. */
  double speed();

  /** Sets that share. */
  void speed(double share);
}
