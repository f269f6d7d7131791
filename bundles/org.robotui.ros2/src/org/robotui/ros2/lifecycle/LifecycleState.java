package org.robotui.ros2.lifecycle;

/**
 * A state of a node.
 *
 * @param id its number, such as 3
 * @param label its name, such as {@code active}
 */
public record LifecycleState(int id, String label) {

  /** Nothing is known. */
  public static final int UNKNOWN = 0;
  /** Made, or cleaned up. */
  public static final int UNCONFIGURED = 1;
  /** Configured, not at work. */
  public static final int INACTIVE = 2;
  /** At work. */
  public static final int ACTIVE = 3;
  /** At its end. */
  public static final int FINALIZED = 4;
}
