package org.robotui.core.internal.config.model;

import java.nio.file.Path;

/** Reads configurations. */
@FunctionalInterface
public interface ConfigSource {
  /**
   * Reads a file and checks all that can be checked with the types installed now. A type that is not installed is a warning:
   * it may appear later.
   *
   * @param file the YAML file
   * @param types what is installed
   * @return problems and RUICs; never throws for anything wrong with the file, also where it is not there
   */
  ConfigResult read(Path file, TypeLookup types);
}
