package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** The world of a simulated robot. The interface {@code simulation}. */
public final class Simulation {

  /** Command: pause. */
  public static final Kind.Command<Empty> PAUSE = new Kind.Command<>("simulation", "pause", Empty.class);

  /** Command: reset. */
  public static final Kind.Command<Empty> RESET = new Kind.Command<>("simulation", "reset", Empty.class);

  /** Command: save. */
  public static final Kind.Command<Empty> SAVE = new Kind.Command<>("simulation", "save", Empty.class);

  /** Request: get pose2d with {@link Pose2dOf}; answered by {@link Pose2dOf}. */
  public static final Kind.Request<Pose2dOf, Pose2dOf> GET_POSE2D =
      new Kind.Request<>("simulation", "get_pose2d", Pose2dOf.class, Pose2dOf.class);

  /** Request: set pose2d by {@link Pose2dOf}; the answer is empty. */
  public static final Kind.Request<Pose2dOf, Empty> SET_POSE2D =
      new Kind.Request<>("simulation", "set_pose2d", Pose2dOf.class, Empty.class);

  /** Request: get pose3d with {@link Pose3dOf}; answered by {@link Pose3dOf}. */
  public static final Kind.Request<Pose3dOf, Pose3dOf> GET_POSE3D =
      new Kind.Request<>("simulation", "get_pose3d", Pose3dOf.class, Pose3dOf.class);

  /** Request: set pose3d by {@link Pose3dOf}; the answer is empty. */
  public static final Kind.Request<Pose3dOf, Empty> SET_POSE3D =
      new Kind.Request<>("simulation", "set_pose3d", Pose3dOf.class, Empty.class);

  /** Request: get property with {@link Property}; answered by {@link Property}. */
  public static final Kind.Request<Property, Property> GET_PROPERTY =
      new Kind.Request<>("simulation", "get_property", Property.class, Property.class);

  /** Request: set property by {@link Property}; the answer is empty. */
  public static final Kind.Request<Property, Empty> SET_PROPERTY =
      new Kind.Request<>("simulation", "set_property", Property.class, Empty.class);

  private Simulation() {}

  /**
   * Where a thing is.
   *
   * @param name the thing's name
   * @param pose in the world; anything in questions
   */
  public record Pose2dOf(String name, Pose2d pose) {}

  /**
   * Where a thing is.
   *
   * @param name the thing's name
   * @param pose in the world; anything in questions
   * @param time simulated time of the answer, microseconds
   */
  public record Pose3dOf(String name, Pose3d pose, double time) {}

  /**
   * What a thing is like.
   *
   * @param name the thing's name
   * @param property which of its properties
   * @param index which of its values, for lists
   * @param value as the simulator keeps it; empty in questions
   */
  public record Property(String name, String property, long index, byte[] value) {}
}
