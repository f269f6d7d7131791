package org.robotui.core.internal.config.model;

import java.nio.file.Path;
import java.util.Optional;

/** Reads configurations. */
public interface ConfigSource {
  /**
   * Reads a file and checks all that can be checked with the types installed now. A type that is not installed is a
   * warning: it may appear later.
   *
   * @param file the YAML file
   * @param types what is installed
   * @return problems and RUICs; never throws for anything wrong with the file, also where it is not there
   */
  ConfigResult read(Path file, TypeLookup types);

  /**
   * The same for a text that is not in its file yet.
   *
   * @param file where it would stand
   * @param text all of it
   * @param types what is installed
   * @return problems and RUICs
   */
  ConfigResult read(Path file, String text, TypeLookup types);

  /**
   * What a text says, section by section, whether it is right or not.
   *
   * @param file where it stands
   * @param text all of it
   * @return its sections; none where it has none
   */
  Optional<WrittenText> written(Path file, String text);
}
