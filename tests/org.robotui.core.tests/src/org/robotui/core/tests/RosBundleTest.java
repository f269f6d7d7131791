package org.robotui.core.tests;

import java.util.List;

/** The bundles that speak ROS come and go. */
class RosBundleTest extends FrameworkBundleCase {
  RosBundleTest() {
    super(new Framework("ros", "org.robotui.ros", List.of(), "scan",
        simulator -> "master: '" + simulator.address("ROS_MASTER_URI") + "', host: 127.0.0.1"));
  }
}
