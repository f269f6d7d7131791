package org.robotui.sim.internal;

import java.util.List;
import java.util.Optional;
import org.robotui.sim.internal.robot.Head;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/**
 * The robot at one moment. Immutable, for any thread.
 *
 * @param time seconds since the start of the simulation
 * @param truth where it really is, in the map
 * @param odometry where its wheels say it is, in the odometry frame
 * @param mapFromOdometry what localisation believes
 * @param speed true speed
 * @param leftWheel radians
 * @param rightWheel radians
 * @param battery state of the battery
 * @param motorsOn whether the motors are switched on
 * @param lost whether localisation is far off
 * @param bumped whether it touches something
 * @param bumpers whether each of its bumpers is pressed
 * @param head where it looks; empty if it has no head that moves
 * @param goal where it drives to
 * @param path the way there, in the map
 * @param goalStatus what became of the last goal
 * @param tuning how it drives
 * @param person where somebody walks, in the map; empty if nobody does
 * @param resets how often it was put back to the start
 */
public record RobotState(
    double time,
    Pose2 truth,
    Pose2 odometry,
    Pose2 mapFromOdometry,
    Speed speed,
    double leftWheel,
    double rightWheel,
    BatteryReading battery,
    boolean motorsOn,
    boolean lost,
    boolean bumped,
    List<Boolean> bumpers,
    Optional<Head> head,
    Optional<Pose2> goal,
    List<Pose2> path,
    GoalStatus goalStatus,
    Tuning tuning,
    Optional<Pose2> person,
    int resets) {
  public Pose2 estimate() {
    return mapFromOdometry.times(odometry);
  }

  /**
   * What the battery shows.
   *
   * @param level 0 to 1
   * @param charge ampere hours
   * @param voltage volts
   * @param current amperes, negative when discharging
   * @param charging whether it is on its charger and not full
   */
  public record BatteryReading(double level, double charge, double voltage, double current, boolean charging) {}
}
