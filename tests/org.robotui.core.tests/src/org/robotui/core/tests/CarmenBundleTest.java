package org.robotui.core.tests;

import java.util.List;

/** The bundles that speak CARMEN come and go. */
class CarmenBundleTest extends FrameworkBundleCase {
  CarmenBundleTest() {
    super(new Framework("carmen", "org.robotui.carmen", List.of("--speak", "carmen"), "robot_frontlaser",
        simulator -> simulator.hostAndPort("CENTRALHOST")));
  }
}
