package org.robotui.core.internal.host;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleContext;
import org.robotui.core.internal.watch.BundleNames;

/** Finds the bundle of a class: by its name, as bundles are named after their root package, else by its class file. */
final class OsgiBundleNames implements BundleNames {
  private final BundleContext context;

  OsgiBundleNames(BundleContext context) {
    this.context = context;
  }

  @Override
  public Optional<String> bundleOf(String className) {
    return byName(className).or(() -> byFile(className)).map(Bundle::getSymbolicName);
  }

  private Optional<Bundle> byName(String className) {
    return Arrays.stream(context.getBundles())
        .filter(b -> b.getSymbolicName() instanceof String name && className.startsWith(name + "."))
        .max(Comparator.comparingInt(b -> b.getSymbolicName().length()));
  }

  private Optional<Bundle> byFile(String className) {
    String file = className.replace('.', '/') + ".class";
    return Arrays.stream(context.getBundles())
        .filter(b -> b.getBundleId() != 0 && b.getSymbolicName() instanceof String && b.getEntry(file) != null)
        .findFirst();
  }
}
