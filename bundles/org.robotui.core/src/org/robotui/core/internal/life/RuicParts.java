package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import org.robotui.api.host.RuicView;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.time.RuicClock;
import org.robotui.core.internal.time.RuicFrames;

/**
 * What the components of one RUIC share.
 *
 * @param configNow as it is configured now
 * @param view the RUIC as its views see it
 * @param services of the host
 * @param serial its worker
 * @param threads in which foreign code is called with a limit
 * @param clock its clock
 * @param frames its frames
 * @param alerts what its views noticed
 * @param overlay what the user changed
 * @param wake what to do when things change
 */
record RuicParts(
    Supplier<RuicConfig> configNow,
    RuicView view,
    Services services,
    Executor serial,
    TrackedThreads threads,
    RuicClock clock,
    RuicFrames frames,
    RuicAlerts alerts,
    RuicOverlay overlay,
    Wake wake) implements ComponentHome {
  RuicConfig config() {
    return configNow.get();
  }

  @Override
  public String ruicName() {
    return config().name();
  }

  /** What to do when things change. Methods never block. */
  interface Wake {
    /** Match again. */
    void rematch();

    /** The link of a robot interface has changed. */
    void linkChanged();

    /** A component failed while it ran. */
    void failed(Object instance, String reason);

    /** A view took too long to answer. */
    default void late(UicInstance instance, Duration limit) {}
  }
}
