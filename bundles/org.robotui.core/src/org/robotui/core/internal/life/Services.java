package org.robotui.core.internal.life;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ScheduledExecutorService;
import java.util.function.Supplier;
import org.robotui.api.UicType.Surface;
import org.robotui.api.command.Principal;
import org.robotui.api.host.RuicView;
import org.robotui.api.time.PointedTime;
import org.robotui.core.internal.command.Arbiters;
import org.robotui.core.internal.config.model.SettingsCheck;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.core.internal.time.WallClock;
import org.robotui.core.internal.watch.BundleNames;
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
 * @param stateFolder where robot interfaces may keep files
 * @param ruics all RUICs of the host
 * @param bundles names bundles
 * @param stage where views can be shown, and as whom they command
 * @param pointed the time at which the user points
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
    Path stateFolder,
    Supplier<List<RuicView>> ruics,
    BundleNames bundles,
    Supplier<Stage> stage,
    PointedTime pointed) {
  /** The same, reporting to somebody else. */
  Services with(Events others) {
    return new Services(registry, check, arbiters, others, watch, timer, clock, wall, stateFolder, ruics, bundles,
        stage, pointed);
  }

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
