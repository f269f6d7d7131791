package org.robotui.sim.internal.robot;

/** A small 12 V battery: discharges with the load, charges on the dock. For one thread. */
public final class Battery {
  public static final double CAPACITY = 3.3;
  private static final double IDLE_CURRENT = 0.5;
  private static final double DRIVE_CURRENT = 4.2;
  private static final double TURN_CURRENT = 0.9;
  private static final double CHARGE_CURRENT = 3.0;
  private static final double RESISTANCE = 0.09;
  private static final double TIME_CONSTANT = 0.3;

  private double charge;
  private double current = -IDLE_CURRENT;
  private boolean charging;

  /** @param level 0 to 1 */
  public Battery(double level) {
    charge = level * CAPACITY;
  }

  /** Lets {@code dt} seconds pass at a speed. */
  public void use(Speed speed, boolean onDock, double dt) {
    double load = IDLE_CURRENT + DRIVE_CURRENT * Math.abs(speed.linear()) + TURN_CURRENT * Math.abs(speed.angular());
    charging = onDock && level() < 1;
    double wanted = charging ? CHARGE_CURRENT - load : -load;
    current += (wanted - current) * Math.min(1, dt / TIME_CONSTANT);
    charge = Math.clamp(charge + current * dt / 3600, 0, CAPACITY);
  }

  public void refill(double level) {
    charge = level * CAPACITY;
  }

  /** 0 to 1. */
  public double level() {
    return charge / CAPACITY;
  }

  /** Ampere hours left. */
  public double charge() {
    return charge;
  }

  /** Amperes, negative when discharging. */
  public double current() {
    return current;
  }

  /** Volts at the terminals. */
  public double voltage() {
    double rest = 11.4 + 1.5 * level() - 0.6 * Math.exp(-level() * 18);
    return rest + current * RESISTANCE;
  }

  public boolean isCharging() {
    return charging;
  }

  public boolean isEmpty() {
    return charge <= 0;
  }
}
