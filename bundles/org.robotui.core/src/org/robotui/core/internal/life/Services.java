package org.robotui.core.internal.life;

import java.util.function.Supplier;
import java.util.concurrent.ScheduledExecutorService;
import org.robotui.api.UicType.Surface;
import org.robotui.api.command.Principal;
import org.robotui.core.internal.command.Arbiters;
import org.robotui.core.internal.config.model.SettingsCheck;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.core.internal.time.WallClock;
import org.robotui.core.internal.watch.Watch;

/**
 * What all RUICs of a host share.
 *
 * @param registry the component types
 * @param check checks settings
 * @param arbiters decide on commands
 * @param events where to report
 * @param watch looks for what hangs
 * @param timer for time-outs; its tasks are short
 * @param clock monotonic
 * @param wall this machine's
 * @param stage where views can be shown, and as whom they command
 */
public record Services(
    Registry registry,
    SettingsCheck check,
    Arbiters arbiters,
    Events events,
    Watch watch,
    ScheduledExecutorService timer,
    NanoClock clock,
    WallClock wall,
    Supplier<Stage> stage) {
  /**
   * What an application offers to views.
   *
   * @param surface where they can be shown
   * @param principal as whom they command
   */
  public record Stage(Surface surface, Principal principal) {
    /** Whether a view can be shown. */
    public boolean shows(Surface wanted) {
      return wanted == Surface.NONE || wanted == surface;
    }
  }
}
