package org.robotui.rfic.roblets.internal.feed;

import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.api.session.PlacedFrames;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.rfic.roblets.internal.RobletsSettings;

/**
 * What all feeds of a session share.
 *
 * @param context what core gives
 * @param settings of the robot interface
 * @param frames names of frames
 * @param tree the robot's frames
 * @param pulse hears of all messages
 */
public record RobletsShared(RficContext context, RobletsSettings settings, RobotFrames frames, PlacedFrames tree,
    Pulse pulse) {
  public RobletsShared(RficContext context, RobletsSettings settings) {
    this(context, settings, settings.frames().of(context.robot()),
        new PlacedFrames(context, "roblets", settings.frames().of(context.robot()).base()), new Pulse());
  }

  /** By what name the brain knows us. */
  public String name() {
    String own = "robotui-" + ProcessHandle.current().pid() + "-" + context.instance();
    return own.replaceAll("[^A-Za-z0-9_.-]", "_").substring(0, Math.min(64, own.length()));
  }

  Optional<Stamp> stamp(long nanos) {
    if (nanos == 0) {
      return Optional.empty();
    }
    context.clock().observed(nanos);
    return Optional.of(new Stamp(nanos, ClockKind.ROBOT));
  }
}
