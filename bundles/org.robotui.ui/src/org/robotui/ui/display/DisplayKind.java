package org.robotui.ui.display;

import java.util.List;
import java.util.Set;
import org.robotui.api.config.Schema;
import org.robotui.data.Data;

/**
 * A kind of what is listed, whether it is drawn in space or in the plane.
 *
 * @param id what a configuration writes behind {@code type:}
 * @param label the name for users
 * @param accepts the data it can show, the most important first
 * @param needs those of which it needs one source at least
 * @param automatic whether a view that nobody configured shows one for each source of the first type
 * @param schema the settings of its kind
 */
public record DisplayKind(
    String id, String label, List<Class<? extends Data>> accepts, Set<Class<? extends Data>> needs, boolean automatic,
    Schema schema) {
  /**
   * Copies the collections.
   *
   * @param id its word
   * @param label its name
   * @param accepts types
   * @param needs types
   * @param automatic whether it is shown by itself
   * @param schema its settings
   */
  public DisplayKind {
    accepts = List.copyOf(accepts);
    needs = Set.copyOf(needs);
  }
}
