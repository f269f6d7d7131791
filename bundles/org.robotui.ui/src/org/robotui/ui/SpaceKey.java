package org.robotui.ui;

import org.eclipse.swt.widgets.Control;

/**
 * Who has the space key. In the views of a robot it stops the robot, but for texts, buttons, and controls that say here
 * that it presses them. Display thread only.
 */
public final class SpaceKey {
  private static final String OWN = "org.robotui.space";

  private SpaceKey() {}

  /**
   * Says that the space key presses a control, and so stops nothing while the focus is there: for what is pressed like
   * a button only, never for lists and pictures.
   *
   * @param control a control that has the focus when the key is pressed
   */
  public static void claim(Control control) {
    control.setData(OWN, Boolean.TRUE);
  }

  /**
   * Whether the space key presses a control.
   *
   * @param control any control
   * @return true if it was claimed
   */
  public static boolean isClaimed(Control control) {
    return Boolean.TRUE.equals(control.getData(OWN));
  }
}
