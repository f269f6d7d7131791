package org.robotui.core.internal.watch;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Tells which bundle a class comes from. */
@FunctionalInterface
public interface BundleNames {
  /** The symbolic name of the bundle of a class, or none where it comes from the platform. */
  Optional<String> bundleOf(String className);

  /** The bundles whose packages or services a bundle uses now, by its symbolic name. */
  default Set<String> usedBy(String bundle) {
    return Set.of();
  }

  /** Every bundle with its version and state, a line each. */
  default List<String> states() {
    return List.of();
  }
}
