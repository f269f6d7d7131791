package org.robotui.core.tests;

import java.util.List;

/** The bundles that speak SmartSoft come and go. */
class SmartSoftBundleTest extends FrameworkBundleCase {
  SmartSoftBundleTest() {
    super(new Framework("smartsoft", "org.robotui.smartsoft", List.of("--speak", "smartsoft"), "laser/laserScan",
        simulator -> simulator.hostAndPort("SMART_NS_ADDR")));
  }
}
