package org.robotui.install.internal;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collection;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleContext;
import org.osgi.framework.BundleException;
import org.osgi.framework.Constants;
import org.osgi.framework.wiring.FrameworkWiring;

/** What is done with bundles of the running framework. */
final class Framework {
  private static final int REFRESH_SECONDS = 20;
  private static final Pattern UNRESOLVED =
      Pattern.compile("Unresolved requirement: (Import-Package|Require-Bundle|Fragment-Host): ([^;\\s]+)(.*)");
  private static final Pattern VERSION = Pattern.compile("version=\"([^\"]+)\"");

  private final BundleContext context;

  Framework(BundleContext context) {
    this.context = context;
  }

  /** The bundle with that symbolic name, which is not the one given. */
  Optional<Bundle> other(String name, Optional<Bundle> than) {
    return Arrays.stream(context.getBundles()).filter(each -> name.equals(each.getSymbolicName()))
        .filter(each -> than.filter(each::equals).isEmpty()).findFirst();
  }

  Optional<Bundle> find(String name, String version) {
    return Arrays.stream(context.getBundles())
        .filter(each -> name.equals(each.getSymbolicName()) && version.equals(each.getVersion().toString()))
        .findFirst();
  }

  Bundle[] all() {
    return context.getBundles();
  }

  /** Installs a jar that the framework reads where it lies, under a location of our own. */
  Bundle install(String location, Path jar) throws BundleException, IOException {
    try (InputStream reference = URI.create("reference:" + jar.toUri()).toURL().openStream()) {
      return context.installBundle(location, reference);
    }
  }

  /** Starts what is not running; a fragment has nothing to start. Where it cannot be, says why. */
  Optional<String> start(Bundle bundle) {
    if (bundle.getHeaders().get(Constants.FRAGMENT_HOST) != null || bundle.getState() == Bundle.ACTIVE
        || bundle.getState() == Bundle.STARTING) {
      return Optional.empty();
    }
    try {
      bundle.start(Bundle.START_TRANSIENT | Bundle.START_ACTIVATION_POLICY);
      return Optional.empty();
    } catch (BundleException e) {
      return Optional.of(reason(e));
    }
  }

  /** Everything that uses these bundles, and they themselves. */
  Collection<Bundle> usersOf(Collection<Bundle> bundles) {
    return wiring().getDependencyClosure(bundles);
  }

  /** Gives back what was replaced, and has its users use what is there now. */
  void refresh(Collection<Bundle> bundles) throws InterruptedException {
    CountDownLatch done = new CountDownLatch(1);
    wiring().refreshBundles(bundles, event -> done.countDown());
    done.await(REFRESH_SECONDS, TimeUnit.SECONDS);
  }

  private FrameworkWiring wiring() {
    return context.getBundle(Constants.SYSTEM_BUNDLE_LOCATION).adapt(FrameworkWiring.class);
  }

  private static String reason(BundleException failure) {
    Matcher unresolved = UNRESOLVED.matcher(String.valueOf(failure.getMessage()));
    if (!unresolved.find()) {
      String cause = failure.getCause() == null ? "" : " (" + failure.getCause() + ")";
      return String.valueOf(failure.getMessage()).lines().findFirst().orElse("") + cause;
    }
    Matcher version = VERSION.matcher(unresolved.group(3));
    return "it needs the " + (unresolved.group(1).startsWith("Import") ? "package " : "bundle ") + unresolved.group(2)
        + (version.find() ? " in version " + version.group(1) : "") + ", which is not installed";
  }
}
