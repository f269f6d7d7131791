package org.robotui.sim.internal.player;

import org.robotui.player.interfaces.Power;
import org.robotui.player.server.ServedDevice;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.RobotState.BatteryReading;

/** {@code power:0}. */
final class Energy implements Part {
  private static final Rate RATE = new Rate(1);
  private static final int ALL = 1 | 2 | 4 | 8 | 16;
  private static final double SECONDS_AN_HOUR = 3600;

  private final ServedDevice device;

  Energy(Bench bench) {
    device = bench.add("power", 0, bench.handler());
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    if (RATE.isDue(step)) {
      BatteryReading battery = state.battery();
      device.publish(Power.STATE, new Power.State(ALL, (float) battery.voltage(), (float) (100 * battery.level()),
          (float) (battery.charge() * SECONDS_AN_HOUR * battery.voltage()),
          (float) (battery.voltage() * battery.current()),
          battery.charging() ? 1 : 0), stamp);
    }
  }
}
