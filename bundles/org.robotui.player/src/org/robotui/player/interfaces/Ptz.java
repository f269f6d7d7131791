package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Heads that pan, tilt and zoom. The interface {@code ptz}. */
public final class Ptz {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("ptz", "state", State.class);

  /** Data: geometry. */
  public static final Kind.Data<Body> GEOMETRY = new Kind.Data<>("ptz", "geometry", Body.class);

  /** Command: move. */
  public static final Kind.Command<Move> MOVE = new Kind.Command<>("ptz", "move", Move.class);

  /** Request: generic with {@link Generic}; answered by {@link Generic}. */
  public static final Kind.Request<Generic, Generic> GENERIC =
      new Kind.Request<>("ptz", "generic", Generic.class, Generic.class);

  /** Request: control mode by {@link Mode}; the answer is empty. */
  public static final Kind.Request<Mode, Empty> CONTROL_MODE =
      new Kind.Request<>("ptz", "control_mode", Mode.class, Empty.class);

  /** Request: get geometry; answered by {@link Body}. */
  public static final Kind.Request<Empty, Body> GET_GEOMETRY =
      new Kind.Request<>("ptz", "get_geometry", Empty.class, Body.class);

  /** Request: get status; answered by {@link Status}. */
  public static final Kind.Request<Empty, Status> GET_STATUS =
      new Kind.Request<>("ptz", "get_status", Empty.class, Status.class);

  private Ptz() {}

  /**
   * Where it looks.
   *
   * @param pan counter-clockwise, radians
   * @param tilt up, radians
   * @param zoom the field of view, radians
   * @param panSpeed counter-clockwise, radians per second
   * @param tiltSpeed up, radians per second
   * @param status in the device's terms
   */
  public record State(float pan, float tilt, float zoom, float panSpeed, float tiltSpeed, long status) {}

  /**
   * Where it shall look.
   *
   * @param pan counter-clockwise, radians
   * @param tilt up, radians
   * @param zoom the field of view, radians
   * @param panSpeed how fast; in velocity mode, counter-clockwise, radians per second
   * @param tiltSpeed how fast; in velocity mode, up, radians per second
   */
  public record Move(float pan, float tilt, float zoom, float panSpeed, float tiltSpeed) {}

  /**
   * In the device's own language.
   *
   * @param words the question or the answer
   */
  public record Generic(long[] words) {}

  /**
   * What commands mean.
   *
   * @param mode 0 velocities, 1 positions
   */
  public record Mode(long mode) {}

  /**
   * How it is.
   *
   * @param status in the device's terms
   */
  public record Status(long status) {}
}
