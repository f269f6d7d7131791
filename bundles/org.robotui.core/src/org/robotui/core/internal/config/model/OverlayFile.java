package org.robotui.core.internal.config.model;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;

/** Reads and writes what users changed. */
public interface OverlayFile {
  /**
   * Reads.
   *
   * @param file where
   * @return overlays by name of the RUIC; empty where there is no file
   * @throws IOException where it cannot be read or understood
   */
  Map<String, Overlay> read(Path file) throws IOException;

  /**
   * Writes, so that a reader sees either the old or the new file; creates missing folders.
   *
   * @param file where
   * @param overlays by name of the RUIC
   * @throws IOException where it cannot be written
   */
  void write(Path file, Map<String, Overlay> overlays) throws IOException;
}
