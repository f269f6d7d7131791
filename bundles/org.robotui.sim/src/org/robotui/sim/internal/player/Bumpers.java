package org.robotui.sim.internal.player;

import java.util.List;
import java.util.Optional;
import org.robotui.player.interfaces.Bumper;
import org.robotui.player.server.ServedDevice;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.sensor.BumperSpec;
import org.robotui.sim.internal.world.Pose2;

/** {@code bumper:0}. */
final class Bumpers implements Part {
  private static final Rate RATE = new Rate(20);

  private final ServedDevice device;

  Bumpers(Bench bench) {
    RobotModel robot = bench.robot().model();
    List<Bumper.Part> parts = robot.bumpers().stream().map(bumper -> part(bumper, robot)).toList();
    device = bench.add("bumper", 0,
        bench.handler().on(Bumper.GET_GEOMETRY, none -> Optional.of(new Bumper.Geometry(parts))));
  }

  private static Bumper.Part part(BumperSpec bumper, RobotModel robot) {
    double bearing = bumper.middle();
    Pose2 middle = new Pose2(robot.radius() * Math.cos(bearing), robot.radius() * Math.sin(bearing), bearing);
    return new Bumper.Part(Poses.mount(middle, robot.height() / 2), (float) bumper.length(robot.radius()),
        (float) robot.radius());
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    if (RATE.isDue(step)) {
      byte[] pressed = new byte[state.bumpers().size()];
      for (int i = 0; i < pressed.length; i++) {
        pressed[i] = (byte) (state.bumpers().get(i) ? 1 : 0);
      }
      device.publish(Bumper.STATE, new Bumper.State(pressed), stamp);
    }
  }
}
