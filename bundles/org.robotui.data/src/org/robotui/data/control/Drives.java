package org.robotui.data.control;

import java.util.List;
import org.robotui.data.Data;

/**
 * The drives of a robot's joints, where they are enabled and disabled one by one.
 *
 * @param drives in the order of the robot's control; none where its hardware has no such life
 */
public record Drives(List<Drive> drives) implements Data {
  /** Where in its life a drive is. */
  public enum Phase {
    /** Its motor is off, and stays so until a user enables it. */
    DISABLED,
    /** It is on its way to be enabled. */
    ENABLING,
    /** It obeys. */
    ENABLED,
    /** Its motor is off, and stays so until a user has it brought back. */
    FAULT,
    /** Nothing is heard of it. */
    SILENT
  }

  /**
   * One drive.
   *
   * @param joint the joint that it moves
   * @param phase where in its life it is
   * @param detail what it says of that, may be empty
   */
  public record Drive(String joint, Phase phase, String detail) {}

  /**
   * Copies the list.
   *
   * @param drives in the order of the robot's control
   */
  public Drives {
    drives = List.copyOf(drives);
  }
}
