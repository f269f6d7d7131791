package org.robotui.install.internal;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.equinox.internal.provisional.configurator.Configurator;
import org.osgi.framework.Bundle;
import org.robotui.install.internal.BundleList.Entry;

/**
 * The bundles that the product consists of, and the running framework with them. What the installer has changed, here
 * or in another process, is taken up at once, unless the application itself stands on what was replaced.
 */
@SuppressWarnings("restriction") // the one who applies the installer's list has no public interface
final class ProductBundles {
  /** Whoever needs a replaced bundle is started anew; these are the application and cannot be. */
  private static final Set<String> APPLICATION = Set.of("org.robotui.core", "org.robotui.workbench",
      "org.robotui.headless", "org.robotui.install", "org.eclipse.osgi", "org.apache.felix.scr");

  /** What an application has taken up. */
  record Applied(Set<Entry> come, Set<Entry> gone, boolean restart) {
    boolean isNothing() {
      return come.isEmpty() && gone.isEmpty();
    }
  }

  private final Configurator configurator;
  private final Framework framework;
  private final Path file;
  private BundleList running;
  private Optional<FileStamp> applied;
  private Optional<FileStamp> seen;

  ProductBundles(Configurator configurator, Framework framework) throws IOException {
    this.configurator = configurator;
    this.framework = framework;
    // The framework does not escape what stands in its addresses.
    file = Path.of(configurator.getUrlInUse().getPath());
    running = BundleList.read(file);
    applied = FileStamp.of(file);
    seen = applied;
  }

  /** Whether another process has changed the list, and has finished writing it. */
  boolean isChanged() {
    Optional<FileStamp> now = FileStamp.of(file);
    boolean still = now.equals(seen);
    seen = now;
    return still && now.isPresent() && !now.equals(applied);
  }

  Applied apply() throws IOException {
    applied = FileStamp.of(file);
    BundleList wanted = BundleList.read(file);
    Set<Entry> gone = running.without(wanted);
    Set<Entry> come = wanted.without(running);
    Applied change = new Applied(come, gone, carriesApplication(gone));
    if (!change.isNothing() && !change.restart()) {
      configurator.applyConfiguration();
      bundles(come).forEach(framework::start);
      running = wanted;
    }
    return change;
  }

  private boolean carriesApplication(Set<Entry> gone) {
    Collection<Bundle> users = framework.usersOf(bundles(gone));
    return users.stream().map(Bundle::getSymbolicName).anyMatch(APPLICATION::contains);
  }

  private List<Bundle> bundles(Set<Entry> entries) {
    return entries.stream().flatMap(entry -> framework.find(entry.name(), entry.version()).stream()).toList();
  }
}
