package org.robotui.core.tests;

import java.util.List;

/** The bundles that speak YARP come and go. */
class YarpBundleTest extends FrameworkBundleCase {
  YarpBundleTest() {
    super(new Framework("yarp", "org.robotui.yarp", List.of("--speak", "yarp"), "laser",
        simulator -> simulator.hostAndPort("YARP_NAMESERVER") + ", prefix: /natalie"));
  }
}
