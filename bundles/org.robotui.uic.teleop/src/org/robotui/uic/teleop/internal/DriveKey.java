package org.robotui.uic.teleop.internal;

/** What keys drive; several together add up. */
enum DriveKey {
  FORWARD(1, 0),
  BACK(-1, 0),
  LEFT(0, 1),
  RIGHT(0, -1),
  FORWARD_LEFT(1, 1),
  FORWARD_RIGHT(1, -1);

  private final Stick stick;

  DriveKey(double forward, double left) {
    stick = new Stick(forward, left);
  }

  Stick stick() {
    return stick;
  }
}
