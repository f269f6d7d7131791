package org.robotui.core.internal.host;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleContext;
import org.osgi.framework.ServiceReference;
import org.osgi.framework.wiring.BundleWiring;
import org.robotui.core.internal.watch.BundleNames;

/**
 * Finds the bundle of a class: by its name, as bundles are named after their root package, else by its class file.
 * Looking for a file in all bundles takes long, and who asks may be the one that stops robots: so each class is looked
 * for once, until bundles come or go.
 */
final class OsgiBundleNames implements BundleNames {
  private static final List<String> PLATFORM = List.of("java.", "javax.", "jdk.", "sun.", "com.sun.");
  private static final int MOST = 10_000;
  private static final Map<Integer, String> STATES = Map.of(Bundle.INSTALLED, "INSTALLED", Bundle.RESOLVED, "RESOLVED",
      Bundle.STARTING, "STARTING", Bundle.ACTIVE, "ACTIVE", Bundle.STOPPING, "STOPPING", Bundle.UNINSTALLED,
      "UNINSTALLED");

  private final BundleContext context;
  private volatile Known known = new Known(0, 0, Map.of());

  /** What was found among as many bundles, the newest of them that one: another installation has another number. */
  private record Known(int bundles, long newest, Map<String, Optional<String>> names) {
    boolean isOf(Bundle[] all) {
      return all.length == bundles && newestOf(all) == newest && names.size() < MOST;
    }

    static Known nothingOf(Bundle[] all) {
      return new Known(all.length, newestOf(all), new ConcurrentHashMap<>());
    }

    private static long newestOf(Bundle[] all) {
      return Arrays.stream(all).mapToLong(Bundle::getBundleId).max().orElse(0);
    }
  }

  OsgiBundleNames(BundleContext context) {
    this.context = context;
  }

  @Override
  public Optional<String> bundleOf(String className) {
    if (PLATFORM.stream().anyMatch(className::startsWith)) {
      return Optional.empty();
    }
    Bundle[] all = context.getBundles();
    Known now = known;
    if (!now.isOf(all)) {
      now = Known.nothingOf(all);
      known = now;
    }
    return now.names().computeIfAbsent(className, name -> find(name, all));
  }

  @Override
  public Set<String> usedBy(String bundle) {
    Set<String> used = new TreeSet<>();
    for (Bundle each : context.getBundles()) {
      if (bundle.equals(each.getSymbolicName())) {
        packages(each).forEach(used::add);
        services(each).forEach(used::add);
      }
    }
    used.remove(bundle);
    return used;
  }

  @Override
  public List<String> states() {
    return Arrays.stream(context.getBundles()).map(each -> String.format(Locale.ROOT, "%4d  %-11s %s %s",
        each.getBundleId(), STATES.getOrDefault(each.getState(), "?"), each.getSymbolicName(), each.getVersion()))
        .toList();
  }

  private static Stream<String> packages(Bundle bundle) {
    return Optional.ofNullable(bundle.adapt(BundleWiring.class)).map(w -> w.getRequiredWires(null)).stream()
        .flatMap(List::stream)
        .map(wire -> wire.getProvider().getBundle()).map(Bundle::getSymbolicName);
  }

  private static Stream<String> services(Bundle bundle) {
    return Optional.ofNullable(bundle.getServicesInUse()).stream().flatMap(Arrays::stream)
        .map(ServiceReference::getBundle).filter(Bundle.class::isInstance).map(Bundle::getSymbolicName);
  }

  private static Optional<String> find(String className, Bundle[] all) {
    return byName(className, all).or(() -> byFile(className, all)).map(Bundle::getSymbolicName);
  }

  private static Optional<Bundle> byName(String className, Bundle[] all) {
    return Arrays.stream(all)
        .filter(b -> b.getSymbolicName() instanceof String name && className.startsWith(name + "."))
        .max(Comparator.comparingInt(b -> b.getSymbolicName().length()));
  }

  private static Optional<Bundle> byFile(String className, Bundle[] all) {
    String file = className.replace('.', '/') + ".class";
    return Arrays.stream(all)
        .filter(b -> b.getBundleId() != 0 && b.getSymbolicName() instanceof String && b.getEntry(file) != null)
        .findFirst();
  }
}
