package org.robotui.rfic.carmen.internal.feed;

import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.api.session.PlacedFrames;
import org.robotui.api.session.RobotFrames;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.module.IpcModule;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.rfic.carmen.internal.CarmenSettings;

/**
 * What all messages of a session share.
 *
 * @param context what core gives
 * @param settings of the robot interface
 * @param module at the central
 * @param forms of CARMEN
 * @param frames names of the robot's frames
 * @param tree where they are
 * @param pulse hears of all messages
 */
public record Shared(RficContext context, CarmenSettings settings, IpcModule module, IpcForms forms,
    RobotFrames frames, PlacedFrames tree, Pulse pulse) {
  private static final double NANOS = 1e9;
  private static final double LAST = 9e9;
  private static final double MILLIS = 1e3;

  /** Programs of CARMEN say when they sent something by the clock of their machine; 0 is no time. */
  Optional<Stamp> stamp(double seconds) {
    if (!(seconds > 0) || seconds > LAST) {
      return Optional.empty();
    }
    long nanos = Math.round(seconds * NANOS);
    context.clock().observed(nanos);
    return Optional.of(new Stamp(nanos, ClockKind.ROBOT));
  }

  double now() {
    return System.currentTimeMillis() / MILLIS;
  }
}
