package org.robotui.uic.console.internal.view;

import java.nio.file.Path;
import java.util.List;
import org.robotui.api.script.ScriptSession.Completion;

/** What the user can do. Display thread; returns at once. */
public interface ConsoleHands {
  /** Runs a text, and keeps the history. */
  void run(String text, List<String> history);

  /** Stops what runs. */
  void stop();

  /** What could stand at the end of a line. */
  Completion complete(String line);

  /** Runs a file. */
  void open(Path file);

  /** Writes what was typed to a file. */
  void save(Path file);
}
