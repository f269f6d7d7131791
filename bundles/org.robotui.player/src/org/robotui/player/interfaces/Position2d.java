package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Mobile bases in the plane. The interface {@code position2d}. */
public final class Position2d {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("position2d", "state", State.class);

  /** Data: geometry. */
  public static final Kind.Data<Body> GEOMETRY = new Kind.Data<>("position2d", "geometry", Body.class);

  /** Command: velocity. */
  public static final Kind.Command<Velocity> VELOCITY = new Kind.Command<>("position2d", "velocity", Velocity.class);

  /** Command: position. */
  public static final Kind.Command<Position> POSITION = new Kind.Command<>("position2d", "position", Position.class);

  /** Command: car. */
  public static final Kind.Command<Car> CAR = new Kind.Command<>("position2d", "car", Car.class);

  /** Command: heading. */
  public static final Kind.Command<Heading> HEADING = new Kind.Command<>("position2d", "heading", Heading.class);

  /** Request: get geometry; answered by {@link Body}. */
  public static final Kind.Request<Empty, Body> GET_GEOMETRY =
      new Kind.Request<>("position2d", "get_geometry", Empty.class, Body.class);

  /** Request: motor power by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> MOTOR_POWER =
      new Kind.Request<>("position2d", "motor_power", Switch.class, Empty.class);

  /** Request: velocity mode by {@link Setting}; the answer is empty. */
  public static final Kind.Request<Setting, Empty> VELOCITY_MODE =
      new Kind.Request<>("position2d", "velocity_mode", Setting.class, Empty.class);

  /** Request: position mode by {@link Setting}; the answer is empty. 0 velocity, 1 position. */
  public static final Kind.Request<Setting, Empty> POSITION_MODE =
      new Kind.Request<>("position2d", "position_mode", Setting.class, Empty.class);

  /** Request: set odometry by {@link Odometry}; the answer is empty. */
  public static final Kind.Request<Odometry, Empty> SET_ODOMETRY =
      new Kind.Request<>("position2d", "set_odometry", Odometry.class, Empty.class);

  /** Request: reset odometry; nothing is asked with it or answered. */
  public static final Kind.Request<Empty, Empty> RESET_ODOMETRY =
      new Kind.Request<>("position2d", "reset_odometry", Empty.class, Empty.class);

  /** Request: velocity pid by {@link Gains}; the answer is empty. */
  public static final Kind.Request<Gains, Empty> VELOCITY_PID =
      new Kind.Request<>("position2d", "velocity_pid", Gains.class, Empty.class);

  /** Request: position pid by {@link Gains}; the answer is empty. */
  public static final Kind.Request<Gains, Empty> POSITION_PID =
      new Kind.Request<>("position2d", "position_pid", Gains.class, Empty.class);

  /** Request: speed profile by {@link Profile}; the answer is empty. */
  public static final Kind.Request<Profile, Empty> SPEED_PROFILE =
      new Kind.Request<>("position2d", "speed_profile", Profile.class, Empty.class);

  private Position2d() {}

  /**
   * What odometry says.
   *
   * @param position where the base is, by its odometry
   * @param velocity in its own frame, per second
   * @param stall whether the motors stall
   */
  public record State(Pose2d position, Pose2d velocity, boolean stall) {}

  /**
   * Drive at a velocity.
   *
   * @param velocity in the base's frame, per second
   * @param motors whether the motors are on
   */
  public record Velocity(Pose2d velocity, boolean motors) {}

  /**
   * Drive to a place.
   *
   * @param position where to, in odometry
   * @param velocity how fast, per second
   * @param motors whether the motors are on
   */
  public record Position(Pose2d position, Pose2d velocity, boolean motors) {}

  /**
   * Drive as a car does.
   *
   * @param velocity forward, metres per second
   * @param angle of the steering, radians
   */
  public record Car(double velocity, double angle) {}

  /**
   * Drive in a direction.
   *
   * @param velocity forward, metres per second
   * @param heading the direction in odometry, radians
   */
  public record Heading(double velocity, double heading) {}

  /**
   * What odometry shall say.
   *
   * @param pose where the base is from now on
   */
  public record Odometry(Pose2d pose) {}
}
