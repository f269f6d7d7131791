package org.robotui.api.host;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletionStage;
import org.robotui.api.FileKind;

/**
 * Opens files such as recordings as robots: a robot interface that says it opens them is tried, the views that fit what
 * the file has are chosen, and the configuration is kept with what users changed, so that the same file is shown the
 * same way again. Safe for all threads.
 */
public interface FileOpener {
  /**
   * What can be opened now.
   *
   * @return by the id of the type that opens them
   */
  List<FileKind> kinds();

  /**
   * Opens a file, after those that were asked for before. Types of robot interfaces may still be on their way: one that
   * opens such a file is waited for some seconds. Reading may take long where a file has no index.
   *
   * @param file the file
   * @return completes on a thread of core with what came of it, never with a failure
   */
  CompletionStage<FileOutcome> open(Path file);
}
