package org.robotui.workbench.internal;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.osgi.framework.startlevel.FrameworkStartLevel;

/**
 * The bundles that the window does not wait for (docs/adr/0022). The product gives them start levels above the one that
 * the framework has when the application begins: core and what robots, views and interfaces consist of, then the
 * installer's. Without such levels, as in an IDE, all have started already.
 */
final class LaterBundles {
  private static final int COMPONENTS = 5;
  private static final int ALL = 6;

  private LaterBundles() {}

  /**
   * Starts them on a thread of the framework.
   *
   * @param levels the framework's
   * @param limit how long that is waited for
   * @return done when core and the components are there, or when the time is over; never fails
   */
  static CompletableFuture<Void> start(FrameworkStartLevel levels, Duration limit) {
    CompletableFuture<Void> components = new CompletableFuture<>();
    if (levels.getStartLevel() >= ALL) {
      components.complete(null);
    } else {
      levels.setStartLevel(COMPONENTS, event -> {
        components.complete(null);
        levels.setStartLevel(ALL);
      });
    }
    return components.completeOnTimeout(null, limit.toMillis(), TimeUnit.MILLISECONDS);
  }
}
