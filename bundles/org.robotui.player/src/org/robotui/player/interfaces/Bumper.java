package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Bumpers around a robot. The interface {@code bumper}. */
public final class Bumper {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("bumper", "state", State.class);

  /** Data: geometry. */
  public static final Kind.Data<Geometry> GEOMETRY = new Kind.Data<>("bumper", "geometry", Geometry.class);

  /** Request: get geometry; answered by {@link Geometry}. */
  public static final Kind.Request<Empty, Geometry> GET_GEOMETRY =
      new Kind.Request<>("bumper", "get_geometry", Empty.class, Geometry.class);

  private Bumper() {}

  /**
   * Which are pressed.
   *
   * @param pressed not 0 for a pressed one; some devices tell the corner
   */
  public record State(byte[] pressed) {}

  /**
   * Where they are.
   *
   * @param bumpers one for each bumper
   */
  public record Geometry(List<Part> bumpers) {}

  /**
   * One bumper.
   *
   * @param pose of its middle, on the robot
   * @param length along it, metres
   * @param radius of its bend, 0 for a straight one, metres
   */
  public record Part(Pose3d pose, float length, float radius) {}
}
