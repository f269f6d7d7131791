package org.robotui.api.script;

import java.util.List;
import java.util.Optional;

/** Functions that a bundle contributes to scripts: an OSGi service. They come and go with it. */
public interface ScriptFunctions {
  /**
   * The functions.
   *
   * @return always the same
   */
  List<ScriptFunction> functions();

  /**
   * Watches what users do by other ways, such as menus, that these functions do as well.
   *
   * @return a new one, which sees what is done from now on; none where a user has no other way
   */
  default Optional<ActionWatch> watch() {
    return Optional.empty();
  }
}
