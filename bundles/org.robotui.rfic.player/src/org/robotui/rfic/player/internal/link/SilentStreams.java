package org.robotui.rfic.player.internal.link;

import java.util.Collection;
import java.util.List;
import org.robotui.rfic.player.internal.device.DeviceFeed;

/**
 * Asks again for data that are wanted and have stopped while others of the same server come. Stage, for one, switches a
 * model off when any of several clients closes it, and sends the others nothing more; it switches it on when it is
 * opened. A simulation that is paused stops all at once: nothing is done then.
 */
final class SilentStreams {
  private SilentStreams() {}

  static void look(Collection<DeviceFeed> feeds, long nowNanos) {
    List<DeviceFeed> regular = feeds.stream().filter(DeviceFeed::isRegular).toList();
    List<DeviceFeed> silent = regular.stream().filter(f -> f.isSilent(nowNanos)).toList();
    if (silent.size() < regular.size() || regular.size() == 1) {
      silent.forEach(f -> f.reopen(nowNanos));
    }
  }
}
