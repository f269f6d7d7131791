package org.robotui.rfic.player.internal.device;

import org.robotui.data.JointState;
import org.robotui.player.interfaces.Actarray;
import org.robotui.rfic.player.internal.convert.States;

/** Rows of actuators. */
final class Arms {
  private Arms() {}

  static void actarray(DeviceFeed feed) {
    Outlet<JointState> outlet = feed.outlet("", JointState.class, "its joints");
    feed.on(Actarray.STATE, outlet, (m, r) -> outlet.publish(States.joints(m, feed.name()), r));
  }
}
