package org.robotui.urdf;

import java.util.Optional;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * How a link moves against the one that carries it.
 *
 * @param name unique in the model
 * @param type how it moves
 * @param parent the link that carries
 * @param child the link that is carried
 * @param parentFromJoint where it is in the parent, at position 0 that of the child
 * @param axis about or along which it moves, of unit length, in the frame of the joint
 * @param limits how far it moves
 * @param soft limits that controllers keep
 * @param mimic where it follows another one
 */
public record Joint(
    String name,
    Type type,
    String parent,
    String child,
    RigidTransform parentFromJoint,
    Vector3 axis,
    Optional<Limits> limits,
    Optional<SoftLimits> soft,
    Optional<Mimic> mimic) {
  /** How a joint moves. */
  public enum Type {
    /** Turns about its axis, within limits. */
    REVOLUTE,
    /** Turns about its axis without end. */
    CONTINUOUS,
    /** Slides along its axis. */
    PRISMATIC,
    /** Does not move. */
    FIXED,
    /** Moves in all six ways. */
    FLOATING,
    /** Moves in the plane across its axis. */
    PLANAR;

    /**
     * Whether one number says where it is.
     *
     * @return true for revolute, continuous and prismatic
     */
    public boolean single() {
      return this == REVOLUTE || this == CONTINUOUS || this == PRISMATIC;
    }
  }

  /**
   * How far, how hard and how fast.
   *
   * @param lower radians or metres
   * @param upper radians or metres
   * @param effort newton metres or newton
   * @param velocity radians or metres a second
   */
  public record Limits(double lower, double upper, double effort, double velocity) {}

  /**
   * Limits that controllers keep ({@code safety_controller}).
   *
   * @param lower radians or metres
   * @param upper radians or metres
   * @param positionGain of the limit of positions
   * @param velocityGain of the limit of speeds
   */
  public record SoftLimits(double lower, double upper, double positionGain, double velocityGain) {}

  /**
   * Its position is multiplier times that of another one plus offset.
   *
   * @param joint the other one
   * @param multiplier factor
   * @param offset radians or metres
   */
  public record Mimic(String joint, double multiplier, double offset) {}
}
