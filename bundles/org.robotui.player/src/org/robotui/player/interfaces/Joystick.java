package org.robotui.player.interfaces;

import org.robotui.player.layout.Kind;

/** Joysticks at the robot. The interface {@code joystick}. */
public final class Joystick {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("joystick", "state", State.class);

  private Joystick() {}

  /**
   * Where the stick is.
   *
   * @param position of each axis
   * @param scale what is full deflection of each axis
   * @param buttons a bit for each pressed one, the first is the lowest
   * @param axes how many axes there are; what the arrays hold after them means nothing
   */
  public record State(int[] position, int[] scale, long buttons, long axes) {}
}
