package org.robotui.core.tests;

import java.util.List;

/** The bundles that speak Player come and go. */
class PlayerBundleTest extends FrameworkBundleCase {
  PlayerBundleTest() {
    super(new Framework("player", "org.robotui.player", List.of("--robot", "keira", "--speak", "player"), "laser:0",
        simulator -> "host: '" + simulator.address("PLAYER_HOST") + "', port: " + simulator.address("PLAYER_PORT")));
  }
}
