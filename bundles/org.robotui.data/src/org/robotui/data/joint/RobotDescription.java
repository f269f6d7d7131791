package org.robotui.data.joint;

import java.util.List;
import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.internal.Check;

/**
 * What a robot is made of, as the texts in which it says so. It is true until the next one.
 *
 * @param robot the robot whose frames carry the names of the links
 * @param name where it comes from, for users: a parameter, a file
 * @param urdf links, joints and forms as URDF; not checked here
 * @param srdf groups and named positions as SRDF; empty where there is none
 * @param packageRoots folders of this machine that are packages or contain packages, in which the meshes that the text
 * names are looked for
 */
@Delivery(expires = false)
public record RobotDescription(String robot, String name, String urdf, String srdf, List<String> packageRoots)
    implements Data {
  /** The most characters of a text. */
  public static final int LONGEST = 16_000_000;

  /**
   * Checks the lengths and copies the list.
   *
   * @param robot whose frames they are
   * @param name where it comes from
   * @param urdf the model
   * @param srdf the groups
   * @param packageRoots folders
   */
  public RobotDescription {
    Check.that(!robot.isBlank(), "robot", "a description belongs to a robot");
    Check.that(!urdf.isBlank() && urdf.length() <= LONGEST, "urdf",
        "must have 1 to " + LONGEST + " characters, has " + urdf.length());
    Check.that(srdf.length() <= LONGEST, "srdf", "must have at most " + LONGEST + " characters, has " + srdf.length());
    packageRoots = List.copyOf(packageRoots);
  }
}
