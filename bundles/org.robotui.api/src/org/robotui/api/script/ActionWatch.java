package org.robotui.api.script;

import java.util.List;

/** Sees what users do, and says it as lines of a script. One thread asks it, some times in a second. */
@FunctionalInterface
public interface ActionWatch {
  /**
   * Says what was done since it was asked before, or since it was made. Must not block.
   *
   * @return lines that do the same, oldest first; see {@link ScriptLine}
   */
  List<String> next();
}
