package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Vehicles in space. The interface {@code position3d}. */
public final class Position3d {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("position3d", "state", State.class);

  /** Data: geometry. */
  public static final Kind.Data<Body> GEOMETRY = new Kind.Data<>("position3d", "geometry", Body.class);

  /** Command: velocity. */
  public static final Kind.Command<Velocity> VELOCITY = new Kind.Command<>("position3d", "velocity", Velocity.class);

  /** Command: position. */
  public static final Kind.Command<Position> POSITION = new Kind.Command<>("position3d", "position", Position.class);

  /** Request: get geometry; answered by {@link Body}. */
  public static final Kind.Request<Empty, Body> GET_GEOMETRY =
      new Kind.Request<>("position3d", "get_geometry", Empty.class, Body.class);

  /** Request: motor power by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> MOTOR_POWER =
      new Kind.Request<>("position3d", "motor_power", Switch.class, Empty.class);

  /** Request: velocity mode by {@link Setting}; the answer is empty. */
  public static final Kind.Request<Setting, Empty> VELOCITY_MODE =
      new Kind.Request<>("position3d", "velocity_mode", Setting.class, Empty.class);

  /** Request: position mode by {@link Setting}; the answer is empty. 0 velocity, 1 position. */
  public static final Kind.Request<Setting, Empty> POSITION_MODE =
      new Kind.Request<>("position3d", "position_mode", Setting.class, Empty.class);

  /** Request: reset odometry; nothing is asked with it or answered. */
  public static final Kind.Request<Empty, Empty> RESET_ODOMETRY =
      new Kind.Request<>("position3d", "reset_odometry", Empty.class, Empty.class);

  /** Request: set odometry by {@link Odometry}; the answer is empty. */
  public static final Kind.Request<Odometry, Empty> SET_ODOMETRY =
      new Kind.Request<>("position3d", "set_odometry", Odometry.class, Empty.class);

  /** Request: velocity pid by {@link Gains}; the answer is empty. */
  public static final Kind.Request<Gains, Empty> VELOCITY_PID =
      new Kind.Request<>("position3d", "velocity_pid", Gains.class, Empty.class);

  /** Request: position pid by {@link Gains}; the answer is empty. */
  public static final Kind.Request<Gains, Empty> POSITION_PID =
      new Kind.Request<>("position3d", "position_pid", Gains.class, Empty.class);

  /** Request: speed profile by {@link Profile}; the answer is empty. */
  public static final Kind.Request<Profile, Empty> SPEED_PROFILE =
      new Kind.Request<>("position3d", "speed_profile", Profile.class, Empty.class);

  private Position3d() {}

  /**
   * What odometry says.
   *
   * @param position where the vehicle is, by its odometry
   * @param velocity in its own frame, per second
   * @param stall whether the motors stall
   */
  public record State(Pose3d position, Pose3d velocity, boolean stall) {}

  /**
   * Move at a velocity.
   *
   * @param velocity in the vehicle's frame, per second
   * @param motors whether the motors are on
   */
  public record Velocity(Pose3d velocity, boolean motors) {}

  /**
   * Move to a place.
   *
   * @param position where to, in odometry
   * @param velocity how fast, per second
   * @param motors whether the motors are on
   */
  public record Position(Pose3d position, Pose3d velocity, boolean motors) {}

  /**
   * What odometry shall say.
   *
   * @param pose where the vehicle is from now on
   */
  public record Odometry(Pose3d pose) {}
}
