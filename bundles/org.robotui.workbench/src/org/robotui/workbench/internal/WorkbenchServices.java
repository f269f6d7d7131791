package org.robotui.workbench.internal;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.eclipse.e4.ui.css.swt.theme.IThemeManager;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleContext;
import org.osgi.framework.BundleException;
import org.osgi.framework.Constants;
import org.osgi.framework.FrameworkUtil;
import org.osgi.framework.ServiceReference;
import org.osgi.framework.startlevel.FrameworkStartLevel;
import org.osgi.util.tracker.ServiceTracker;
import org.robotui.api.bridge.Bridges;
import org.robotui.api.host.Host;
import org.robotui.api.record.Recorder;
import org.robotui.api.replay.OffsetEstimation;
import org.robotui.api.replay.RecordingComparison;
import org.robotui.api.replay.RecordingReports;
import org.robotui.api.replay.RecordingVideos;
import org.robotui.api.replay.RecordingSearch;
import org.robotui.api.replay.Timeline;
import org.robotui.api.script.Scripts;
import org.robotui.install.FeatureInstaller;
import org.robotui.install.InstallListener;
import org.slf4j.LoggerFactory;

/**
 * The one place that asks OSGi for services. What the extension registry creates (the application, parts, handlers)
 * gets nothing injected; it asks here, and hands on by constructors.
 */
@SuppressWarnings("restriction") // the platform has no public way to set a theme
public final class WorkbenchServices {
  private WorkbenchServices() {}

  /** Waits for the core, which may start after the application. */
  public static Optional<Host> host(Duration limit) throws InterruptedException {
    ServiceTracker<Host, Host> tracker = new ServiceTracker<>(context(), Host.class, null);
    tracker.open();
    try {
      return Optional.ofNullable(tracker.waitForService(limit.toMillis()));
    } finally {
      tracker.close();
    }
  }

  /**
   * Starts the bundles that the window does not wait for; done when core and the components are there, or after the
   * limit.
   */
  static CompletableFuture<Void> startLaterBundles(Duration limit) {
    return LaterBundles.start(context().getBundle(Constants.SYSTEM_BUNDLE_ID).adapt(FrameworkStartLevel.class), limit);
  }

  /** Makes the session of the running application known to parts and handlers. */
  public static Runnable publish(WorkbenchSession session) {
    return context().registerService(WorkbenchSession.class, session, null)::unregister;
  }

  /** The session of the running application. */
  public static WorkbenchSession session() {
    return service(WorkbenchSession.class)
        .orElseThrow(() -> new IllegalStateException("the workbench was not started by its application"));
  }

  /** The engine of style sheets. */
  public static Optional<IThemeManager> themes() {
    return service(IThemeManager.class);
  }

  /** What installs features; it starts last. */
  public static Optional<FeatureInstaller> installer() {
    return service(FeatureInstaller.class);
  }

  /** Has somebody told what bundles come and go by themselves; running the result ends that. */
  static Runnable listen(InstallListener listener) {
    return context().registerService(InstallListener.class, listener, null)::unregister;
  }

  /** What records robots; not there where it is not installed. */
  public static Optional<Recorder> recorder() {
    return service(Recorder.class);
  }

  /** What carries values between robots; not there where it is not installed. */
  static Optional<Bridges> bridges() {
    return service(Bridges.class);
  }

  /** What runs scripts. */
  static Optional<Scripts> scripts() {
    return service(Scripts.class);
  }

  /** What searches recordings; not there where they cannot be played. */
  static Optional<RecordingSearch> search() {
    return service(RecordingSearch.class);
  }

  /** What compares recordings; not there where they cannot be played. */
  static Optional<RecordingComparison> comparison() {
    return service(RecordingComparison.class);
  }

  /** What estimates offsets of recordings; not there where they cannot be played. */
  static Optional<OffsetEstimation> offsets() {
    return service(OffsetEstimation.class);
  }

  /** What writes reports of recordings; not there where they cannot be played. */
  static Optional<RecordingVideos> videos() {
    return service(RecordingVideos.class);
  }

  static Optional<RecordingReports> reports() {
    return service(RecordingReports.class);
  }

  /** Has somebody told of the timeline of recordings as it comes and goes; running the result ends that. */
  static Runnable timelines(Consumer<Optional<Timeline>> told) {
    ServiceTracker<Timeline, Timeline> tracker = new ServiceTracker<>(context(), Timeline.class, null) {
      @Override
      public Timeline addingService(ServiceReference<Timeline> reference) {
        Timeline found = super.addingService(reference);
        told.accept(Optional.ofNullable(found));
        return found;
      }

      @Override
      public void removedService(ServiceReference<Timeline> reference, Timeline gone) {
        told.accept(Optional.empty());
        super.removedService(reference, gone);
      }
    };
    tracker.open();
    return tracker::close;
  }

  private static <S> Optional<S> service(Class<S> type) {
    return Optional.ofNullable(context().getServiceReference(type)).map(context()::getService);
  }

  private static BundleContext context() {
    return FrameworkUtil.getBundle(WorkbenchServices.class).getBundleContext();
  }

  /** Leaves a bundle out of this run. */
  public static void disable(String bundle) {
    for (Bundle each : context().getBundles()) {
      if (each.getSymbolicName().equals(bundle)) {
        try {
          each.stop(Bundle.STOP_TRANSIENT);
        } catch (BundleException e) {
          LoggerFactory.getLogger(WorkbenchServices.class).warn("{} could not be left out", bundle, e);
        }
      }
    }
  }
}
