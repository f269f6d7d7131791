package org.robotui.testkit;

import java.lang.management.ManagementFactory;
import java.lang.management.OperatingSystemMXBean;

/** How busy the machine is, for tests that bound how long something may take. */
public final class MachineLoad {
  private MachineLoad() {}

  /**
   * How many times longer than alone something takes now.
   *
   * @return 1 or more
   */
  public static double factor() {
    OperatingSystemMXBean machine = ManagementFactory.getOperatingSystemMXBean();
    return Math.max(1, machine.getSystemLoadAverage() / machine.getAvailableProcessors());
  }
}
