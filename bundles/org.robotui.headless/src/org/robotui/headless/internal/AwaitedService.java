package org.robotui.headless.internal;

import java.time.Duration;
import java.util.Optional;
import org.osgi.framework.BundleContext;
import org.osgi.util.tracker.ServiceTracker;

/**
 * A service that the application needs: the core, the installer, what runs scripts. An application is made by the
 * extension registry, which injects nothing: this is the one place that asks for services.
 */
final class AwaitedService<S> implements AutoCloseable {
  private final ServiceTracker<S, S> tracker;

  AwaitedService(BundleContext context, Class<S> type) {
    tracker = new ServiceTracker<>(context, type, null);
    tracker.open();
  }

  /** Waits for the service, which may start after the application. */
  Optional<S> await(Duration limit) throws InterruptedException {
    return Optional.ofNullable(tracker.waitForService(limit.toMillis()));
  }

  @Override
  public void close() {
    tracker.close();
  }
}
