package org.robotui.core.internal.watch;

import java.util.Optional;

/** Tells which bundle a class comes from. */
@FunctionalInterface
public interface BundleNames {
  /** The symbolic name of the bundle of a class, or none where it comes from the platform. */
  Optional<String> bundleOf(String className);
}
