package org.robotui.uic.log.internal.view;

import java.nio.file.Path;
import java.util.List;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.LogLine;

/** What the user can do with the log. Display thread; nothing blocks. */
public interface LogHands {
  /** Shows what a filter leaves. */
  void filter(LogFilter next);

  /** Ends all filters. */
  void showAll();

  /** Holds what is shown, or goes on. */
  void pause(boolean on);

  /** Forgets all entries. */
  void clear();

  /** Shows the list of nodes, or not. */
  void nodes(boolean shown);

  /** Writes lines to a file, in the background. */
  void save(List<LogLine> lines, Path file);
}
