package org.robotui.sim.internal.player;

import java.util.Optional;
import org.robotui.player.interfaces.Angles;
import org.robotui.player.interfaces.Pose3d;
import org.robotui.player.layout.Empty;
import org.robotui.player.server.ServedDevice;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.sensor.Imu;

/** {@code imu:0}; clients choose what it sends. */
final class Inertia implements Part {
  private static final Rate RATE = new Rate(50);
  private static final int STATE = 1;
  private static final int CALIBRATED = 2;
  private static final int QUATERNION = 3;
  private static final int EULER = 4;
  private static final int FULL_STATE = 5;

  private final Bench bench;
  private final ServedDevice device;
  private volatile int type = STATE;
  private volatile boolean reset;
  private double zero;

  Inertia(Bench bench) {
    this.bench = bench;
    device = bench.add("imu", 0, bench.handler()
        .on(org.robotui.player.interfaces.Imu.SET_DATA_TYPE, wish -> choose(wish.value()))
        .on(org.robotui.player.interfaces.Imu.RESET_ORIENTATION, any -> reset()));
  }

  private Optional<Empty> choose(int wish) {
    if (wish < STATE || wish > FULL_STATE) {
      return Optional.empty();
    }
    type = wish;
    return Optional.of(new Empty());
  }

  private Optional<Empty> reset() {
    reset = true;
    return Optional.of(new Empty());
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    Imu imu = bench.robot().simulation().imu();
    if (reset) {
      zero = imu.heading();
      reset = false;
    }
    if (RATE.isDue(step) && device.clients() > 0) {
      publish(imu, state, stamp);
    }
  }

  private void publish(Imu imu, RobotState state, double stamp) {
    double yaw = Math.IEEEremainder(imu.heading() - zero, 2 * Math.PI);
    var measured = new org.robotui.player.interfaces.Imu.Calibrated(
        (float) imu.forward(), (float) imu.sideways(), (float) Imu.GRAVITY, 0, 0, (float) imu.turnRate(), 0, 0, 0);
    Pose3d pose = new Pose3d(0, 0, 0, 0, 0, yaw);
    switch (type) {
      case CALIBRATED -> device.publish(org.robotui.player.interfaces.Imu.CALIBRATED, measured, stamp);
      case QUATERNION -> device.publish(org.robotui.player.interfaces.Imu.QUATERNION,
          new org.robotui.player.interfaces.Imu.Quaternion(
              measured, (float) Math.cos(yaw / 2), 0, 0, (float) Math.sin(yaw / 2)),
          stamp);
      case EULER -> device.publish(org.robotui.player.interfaces.Imu.EULER,
          new org.robotui.player.interfaces.Imu.Euler(measured, new Angles(0, 0, (float) yaw)), stamp);
      case FULL_STATE -> device.publish(org.robotui.player.interfaces.Imu.FULL_STATE,
          new org.robotui.player.interfaces.Imu.FullState(
              pose, new Pose3d(state.speed().linear(), 0, 0, 0, 0, imu.turnRate()),
              new Pose3d(imu.forward(), imu.sideways(), Imu.GRAVITY, 0, 0, 0)),
          stamp);
      default -> device.publish(org.robotui.player.interfaces.Imu.STATE,
          new org.robotui.player.interfaces.Imu.State(pose), stamp);
    }
  }
}
