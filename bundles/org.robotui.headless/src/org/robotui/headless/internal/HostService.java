package org.robotui.headless.internal;

import java.time.Duration;
import java.util.Optional;
import org.osgi.framework.BundleContext;
import org.osgi.util.tracker.ServiceTracker;
import org.robotui.api.host.Host;

/**
 * The core. An application is made by the extension registry, which injects nothing: this is the one place that asks
 * for the service.
 */
final class HostService implements AutoCloseable {
  private final ServiceTracker<Host, Host> tracker;

  HostService(BundleContext context) {
    tracker = new ServiceTracker<>(context, Host.class, null);
    tracker.open();
  }

  /** Waits for the core, which may start after the application. */
  Optional<Host> await(Duration limit) throws InterruptedException {
    return Optional.ofNullable(tracker.waitForService(limit.toMillis()));
  }

  @Override
  public void close() {
    tracker.close();
  }
}
