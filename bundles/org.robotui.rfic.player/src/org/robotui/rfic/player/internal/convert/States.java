package org.robotui.rfic.player.internal.convert;

import org.robotui.data.sensor.Battery;
import org.robotui.player.interfaces.Power;

/** What devices say of their own state. */
public final class States {
  private static final int VOLTS = 1;
  private static final int WATTS = 2;
  private static final int PERCENT = 8;
  private static final int CHARGING = 16;

  private States() {}

  public static Battery battery(Power.State m) {
    double volts = (m.valid() & VOLTS) != 0 ? m.volts() : Double.NaN;
    double watts = (m.valid() & WATTS) != 0 ? m.watts() : Double.NaN;
    double charge = (m.valid() & PERCENT) != 0 ? m.percent() / 100 : Double.NaN;
    double current = volts > 0 ? watts / volts : Double.NaN;
    return new Battery(volts, current, charge >= 0 && charge <= 1 ? charge : Double.NaN, status(m, watts));
  }

  private static Battery.Status status(Power.State m, double watts) {
    boolean told = (m.valid() & CHARGING) != 0;
    if (told && m.charging() > 0) {
      return Battery.Status.CHARGING;
    }
    if (told && m.charging() < 0 || watts < 0) {
      return Battery.Status.DISCHARGING;
    }
    return told ? Battery.Status.NOT_CHARGING : Battery.Status.UNKNOWN;
  }
}
