package org.robotui.sim.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.sim.internal.camera.Lens;
import org.robotui.sim.internal.robot.DriveLimits;
import org.robotui.sim.internal.robot.OdometryErrors;
import org.robotui.sim.internal.robot.Wheels;
import org.robotui.sim.internal.sensor.BumperSpec;
import org.robotui.sim.internal.sensor.LaserSpec;
import org.robotui.sim.internal.sensor.LidarSpec;
import org.robotui.sim.internal.sensor.SonarSpec;

/**
 * What a round robot with two driven wheels is like, and where it lives.
 *
 * @param name in lower case
 * @param building name of the floor plan
 * @param radius of the body, metres
 * @param height of the body, metres
 * @param wheels the two that are driven
 * @param limits of the drive
 * @param odometryErrors how wrong the wheels measure
 * @param laser the scanner
 * @param sonars the ring of sonars; one without sensors if it has none
 * @param bumpers what tells of contact; if it has any, contact also stops it until it backs off
 * @param lidar the spinning scanner
 * @param lens the camera
 * @param head whether it has a head that moves
 */
public record RobotModel(
    String name,
    String building,
    double radius,
    double height,
    Wheels wheels,
    DriveLimits limits,
    OdometryErrors odometryErrors,
    LaserSpec laser,
    SonarSpec sonars,
    List<BumperSpec> bumpers,
    Optional<LidarSpec> lidar,
    Lens lens,
    boolean head) {
  public RobotModel {
    bumpers = List.copyOf(bumpers);
  }
}
