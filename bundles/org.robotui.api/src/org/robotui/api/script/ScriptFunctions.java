package org.robotui.api.script;

import java.util.List;

/** Functions that a bundle contributes to scripts: an OSGi service. They come and go with it. */
public interface ScriptFunctions {
  /**
   * The functions.
   *
   * @return always the same
   */
  List<ScriptFunction> functions();
}
