package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Rows of actuators, such as the joints of an arm. The interface {@code actarray}. */
public final class Actarray {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("actarray", "state", State.class);

  /** Command: position. */
  public static final Kind.Command<Position> POSITION = new Kind.Command<>("actarray", "position", Position.class);

  /** Command: positions. */
  public static final Kind.Command<Positions> POSITIONS = new Kind.Command<>("actarray", "positions", Positions.class);

  /** Command: speed. */
  public static final Kind.Command<Speed> SPEED = new Kind.Command<>("actarray", "speed", Speed.class);

  /** Command: speeds. */
  public static final Kind.Command<Speeds> SPEEDS = new Kind.Command<>("actarray", "speeds", Speeds.class);

  /** Command: home. */
  public static final Kind.Command<Joint> HOME = new Kind.Command<>("actarray", "home", Joint.class);

  /** Command: current. */
  public static final Kind.Command<Current> CURRENT = new Kind.Command<>("actarray", "current", Current.class);

  /** Command: currents. */
  public static final Kind.Command<Currents> CURRENTS = new Kind.Command<>("actarray", "currents", Currents.class);

  /** Request: power by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> POWER =
      new Kind.Request<>("actarray", "power", Switch.class, Empty.class);

  /** Request: brakes by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> BRAKES =
      new Kind.Request<>("actarray", "brakes", Switch.class, Empty.class);

  /** Request: get geometry; answered by {@link Geometry}. */
  public static final Kind.Request<Empty, Geometry> GET_GEOMETRY =
      new Kind.Request<>("actarray", "get_geometry", Empty.class, Geometry.class);

  /** Request: set speed by {@link Speed}; the answer is empty. */
  public static final Kind.Request<Speed, Empty> SET_SPEED =
      new Kind.Request<>("actarray", "set_speed", Speed.class, Empty.class);

  /** Request: set acceleration by {@link Acceleration}; the answer is empty. */
  public static final Kind.Request<Acceleration, Empty> SET_ACCELERATION =
      new Kind.Request<>("actarray", "set_acceleration", Acceleration.class, Empty.class);

  private Actarray() {}

  /**
   * Where the actuators are.
   *
   * @param actuators from the base on
   * @param motors whether they have power
   */
  public record State(List<Actuator> actuators, boolean motors) {}

  /**
   * One of them.
   *
   * @param position of the joint, metres or radians
   * @param speed of the joint, metres or radians per second
   * @param acceleration of the joint, metres or radians per second squared
   * @param current of the motor, amperes
   * @param state 1 idle, 2 moving, 4 braked, 8 stalled
   */
  public record Actuator(float position, float speed, float acceleration, float current, int state) {}

  /**
   * How they are built.
   *
   * @param actuators from the base on
   * @param base where the base is
   * @param orientation how the base is turned
   */
  public record Geometry(List<Link> actuators, Point3d base, Angles orientation) {}

  /**
   * What one moves.
   *
   * @param type 1 linear, 2 rotary
   * @param length to the next one, metres
   * @param orientation with all joints at zero
   * @param axis what it turns about or moves along
   * @param min the least position, metres or radians
   * @param centre the middle, metres or radians
   * @param max the greatest position, metres or radians
   * @param home where it goes when sent home, metres or radians
   * @param speed as it is set, metres or radians per second
   * @param brakes whether it has brakes
   */
  public record Link(
      int type, float length, Angles orientation, Point3d axis, float min, float centre, float max, float home,
      float speed,
      boolean brakes) {}

  /**
   * Where one joint shall go.
   *
   * @param joint which one, from 0
   * @param position where to, metres or radians
   */
  public record Position(int joint, float position) {}

  /**
   * Where all joints shall go.
   *
   * @param positions one for each joint, metres or radians
   */
  public record Positions(float[] positions) {}

  /**
   * How fast one joint shall move.
   *
   * @param joint which one, from 0; -1 for all in requests
   * @param speed how fast, metres or radians per second
   */
  public record Speed(int joint, float speed) {}

  /**
   * How fast all joints shall move.
   *
   * @param speeds one for each joint, metres or radians per second
   */
  public record Speeds(float[] speeds) {}

  /**
   * Which joint.
   *
   * @param joint from 0; -1 for all
   */
  public record Joint(int joint) {}

  /**
   * What current one joint shall get.
   *
   * @param joint which one, from 0
   * @param current of its motor, amperes
   */
  public record Current(int joint, float current) {}

  /**
   * What currents all joints shall get.
   *
   * @param currents one for each joint, amperes
   */
  public record Currents(float[] currents) {}

  /**
   * How fast one joint may change its speed.
   *
   * @param joint which one, from 0; -1 for all
   * @param acceleration of the joint, metres or radians per second squared
   */
  public record Acceleration(int joint, float acceleration) {}
}
