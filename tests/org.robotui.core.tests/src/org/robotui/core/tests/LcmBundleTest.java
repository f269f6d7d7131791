package org.robotui.core.tests;

import java.util.List;

/** The bundles that speak LCM come and go. */
class LcmBundleTest extends FrameworkBundleCase {
  private static final String TYPES = Simulator.LCM_TYPES.toString();

  LcmBundleTest() {
    super(new Framework("lcm", "org.robotui.lcm", List.of("--speak", "lcm", "--lcm-types", TYPES), "LASER",
        simulator -> "url: '" + simulator.address("LCM_DEFAULT_URL") + "', types: '" + TYPES
            + "', channels: {LASER: {as: laserscan, type: robotui.laser_t}}"));
  }
}
