package org.robotui.core.tests;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.eclipse.core.runtime.FileLocator;
import org.junit.jupiter.api.Assertions;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleContext;
import org.osgi.framework.BundleException;
import org.osgi.framework.Constants;
import org.osgi.framework.FrameworkEvent;
import org.osgi.framework.FrameworkUtil;
import org.osgi.framework.wiring.FrameworkWiring;

/** Brings and takes away bundles of the running framework, by their symbolic names. */
final class Bundles {
  private static final int REFRESH_SECONDS = 30;

  private Bundles() {}

  static BundleContext context() {
    return FrameworkUtil.getBundle(Bundles.class).getBundleContext();
  }

  static Bundle find(String name) {
    return Arrays.stream(context().getBundles()).filter(b -> name.equals(b.getSymbolicName())).findFirst()
        .orElseGet(() -> Assertions.fail("bundle " + name + " is not installed"));
  }

  /** Starts it as the products do. */
  static void start(String name) throws BundleException {
    find(name).start(Bundle.START_ACTIVATION_POLICY);
  }

  static void stop(String name) throws BundleException {
    find(name).stop();
  }

  static Installed uninstall(String name) throws BundleException, IOException {
    Bundle bundle = find(name);
    Installed installed = new Installed(name, bundle.getLocation(), Files.readAllBytes(file(name)));
    bundle.uninstall();
    return installed;
  }

  /** Installs it anew and starts it. */
  static void install(Installed bundle) throws BundleException {
    context().installBundle(bundle.location(), new ByteArrayInputStream(bundle.jar()));
    start(bundle.name());
  }

  /** Gives bundles, and those that are wired to them, new class loaders; without names those that were uninstalled. */
  static void refresh(String... names) throws InterruptedException {
    List<Bundle> bundles = Arrays.stream(names).map(Bundles::find).toList();
    CountDownLatch done = new CountDownLatch(1);
    context().getBundle(Constants.SYSTEM_BUNDLE_LOCATION).adapt(FrameworkWiring.class)
        .refreshBundles(bundles.isEmpty() ? null : bundles, event -> {
          if (event.getType() == FrameworkEvent.PACKAGES_REFRESHED) {
            done.countDown();
          }
        });
    Assertions.assertTrue(done.await(REFRESH_SECONDS, TimeUnit.SECONDS), "the packages are refreshed");
  }

  static Path file(String name) {
    return FileLocator.getBundleFileLocation(find(name)).map(File::toPath)
        .orElseGet(() -> Assertions.fail("bundle " + name + " has no file"));
  }
}
