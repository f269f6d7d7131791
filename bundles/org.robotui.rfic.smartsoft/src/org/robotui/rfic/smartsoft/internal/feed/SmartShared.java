package org.robotui.rfic.smartsoft.internal.feed;

import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.api.session.PlacedFrames;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.message.DynamicMessage;
import org.robotui.rfic.smartsoft.internal.SmartSettings;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.wire.LinkOptions;

/**
 * What all services of a session share.
 *
 * @param context what core gives
 * @param settings of the robot interface
 * @param links how services are linked to
 * @param types of objects
 * @param frames names of the robot's frames
 * @param tree where they are
 * @param pulse hears of all updates
 */
public record SmartShared(RficContext context, SmartSettings settings, LinkOptions links, CommTypes types,
    RobotFrames frames, PlacedFrames tree, Pulse pulse) {
  private static final long MICRO = 1000;

  /** Components say when they measured something by the clock of their machine; 0 is no time. */
  Optional<Stamp> stamp(DynamicMessage object, String field) {
    long seconds = (long) object.number(field + ".sec").orElse(0);
    long micros = (long) object.number(field + ".usec").orElse(0);
    if (seconds <= 0) {
      return Optional.empty();
    }
    Stamp stamp = Stamp.of(seconds, micros * MICRO, ClockKind.ROBOT);
    context.clock().observed(stamp.nanos());
    return Optional.of(stamp);
  }
}
