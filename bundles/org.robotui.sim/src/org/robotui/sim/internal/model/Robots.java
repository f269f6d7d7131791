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

/** The robots that can be simulated. */
public final class Robots {
  /** Like a Pioneer 3-DX with a SICK laser, and a mast that carries a spinning scanner, a camera and a head. */
  public static final RobotModel NATALIE = new RobotModel(
      "natalie", "floorplan", 0.25, 0.65, new Wheels(0.0975, 0.331), DriveLimits.DEMO, OdometryErrors.DEMO,
      LaserSpec.DEMO,
      SonarSpec.PIONEER, List.of(), Optional.of(LidarSpec.DEMO), Lens.DEMO, true);

  /** Like a Roomba with a small Hokuyo laser and a camera on top. */
  public static final RobotModel KEIRA = new RobotModel(
      "keira", "apartment", 0.17, 0.18, new Wheels(0.036, 0.235), new DriveLimits(0.5, 2.5, 0.8, 6.0),
      new OdometryErrors(0.99, 1.012, -0.004, 0.005),
      new LaserSpec(Math.toRadians(240), 683, 0.02, 4.0, 0.01, 0.04, 0.15, 10), SonarSpec.NONE,
      List.of(new BumperSpec("left", Math.toRadians(-10), Math.toRadians(90)),
          new BumperSpec("right", Math.toRadians(-90), Math.toRadians(10))),
      Optional.empty(), new Lens(320, 240, Math.toRadians(72), 0.12, 0.22), false);

  private static final List<RobotModel> ALL = List.of(NATALIE, KEIRA);

  private Robots() {}

  /** The robot of a name, in upper or lower case. */
  public static Optional<RobotModel> named(String name) {
    return ALL.stream().filter(model -> model.name().equalsIgnoreCase(name)).findFirst();
  }

  public static List<String> names() {
    return ALL.stream().map(RobotModel::name).toList();
  }
}
