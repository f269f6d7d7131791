package org.robotui.sim.internal.yarp;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.sensor.Imu;
import org.robotui.sim.internal.sensor.LaserSpec;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.yarp.bottle.Bottle;

/** Makes what the robot says, as devices of YARP do: angles are degrees. */
final class YarpSayings {
  private static final int SENSOR_KINDS = 10;
  private static final double WHOLE = 100;

  private final SimulatedRobot robot;

  YarpSayings(SimulatedRobot robot) {
    this.robot = robot;
  }

  Bottle odometry(RobotState state) {
    Pose2 at = state.odometry();
    double speed = state.speed().linear();
    double turning = Math.toDegrees(state.speed().angular());
    return Bottle.reals(at.x(), at.y(), Math.toDegrees(at.yaw()), speed, 0, turning, speed * Math.cos(at.yaw()),
        speed * Math.sin(at.yaw()), turning);
  }

  /** The name of a map, where the robot is on it, and a description. */
  Bottle place(RobotState state) {
    Pose2 at = state.estimate();
    return Bottle.of(robot.model().building(), at.x(), at.y(), Math.toDegrees(at.yaw()), "");
  }

  /** The last angle is one beam behind the last beam, as YARP's scanners say it. */
  Bottle scan(float[] ranges) {
    LaserSpec spec = robot.model().laser();
    List<Object> said = new ArrayList<>();
    for (float range : ranges) {
      said.add((double) range);
    }
    return Bottle.of(Math.toDegrees(spec.angleMin()),
        Math.toDegrees(spec.angleMin() + spec.increment() * ranges.length), spec.rangeMin(), spec.rangeMax(), said, 1);
  }

  /** Ten kinds of sensors: gyroscopes, accelerometers, magnetometers, orientations, and others. */
  Bottle imu(double now) {
    Imu imu = robot.simulation().imu();
    List<Object> kinds = new ArrayList<>(Collections.nCopies(SENSOR_KINDS, List.of()));
    kinds.set(0, sensor(now, 0, 0, Math.toDegrees(imu.turnRate())));
    kinds.set(1, sensor(now, imu.forward(), imu.sideways(), Imu.GRAVITY));
    kinds.set(3, sensor(now, 0, 0, Math.toDegrees(imu.heading())));
    return Bottle.of(kinds.toArray());
  }

  private static List<Object> sensor(double now, double x, double y, double z) {
    return List.of(List.of(Bottle.reals(x, y, z), now));
  }

  Bottle battery(RobotState state) {
    RobotState.BatteryReading battery = state.battery();
    return Bottle.of(battery.voltage(), battery.current(), WHOLE * battery.level(), 20.0, battery.charging() ? 1 : 2);
  }
}
