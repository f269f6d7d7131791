package org.robotui.core.tests;

import java.util.List;

/** The bundles that speak ROS 2 come and go. */
class Ros2BundleTest extends FrameworkBundleCase {
  Ros2BundleTest() {
    super(new Framework("ros2", "org.robotui.ros2", List.of("--speak", "ros2"), "scan",
        simulator -> "domain: " + simulator.address("ROS_DOMAIN_ID")));
  }
}
