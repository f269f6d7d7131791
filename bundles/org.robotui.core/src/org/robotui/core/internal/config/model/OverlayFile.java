package org.robotui.core.internal.config.model;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.Consumer;

/** Reads and writes what users changed. */
public interface OverlayFile {
  /**
   * Reads.
   *
   * @param file where
   * @param damage is told, in a sentence, of each RUIC of which what is kept cannot be understood; it is left out
   * @return overlays by name of the RUIC; empty where there is no file
   * @throws IOException where nothing of it can be read or understood
   */
  Map<String, Overlay> read(Path file, Consumer<String> damage) throws IOException;

  /**
   * Writes, so that a reader sees either the old or the new file; creates missing folders.
   *
   * @param file where
   * @param overlays by name of the RUIC
   * @throws IOException where it cannot be written
   */
  void write(Path file, Map<String, Overlay> overlays) throws IOException;

  /**
   * Writes a perspective for others.
   *
   * @param perspective what
   * @return YAML
   */
  String text(PerspectiveFile perspective);

  /**
   * Reads a perspective that somebody else has written.
   *
   * @param text YAML
   * @return what it says
   * @throws IOException where it is no perspective; says why
   */
  PerspectiveFile perspective(String text) throws IOException;
}
