package org.robotui.api;

import java.util.List;
import java.util.stream.Stream;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout;

/**
 * A type of robot user interface: which views, where. It names views by type id only; core creates and connects them. A
 * configuration may replace or add views and the layout.
 */
public interface RuicType extends ComponentType {
  /**
   * The views of such an interface.
   *
   * @param settings checked against the schema
   * @return the views in the order of their importance
   */
  List<UicSpec> uics(Settings settings);

  /**
   * Where the views lie.
   *
   * @param settings checked against the schema
   * @return the layout, naming views of {@link #uics}
   */
  Layout layout(Settings settings);

  /**
   * A view to create.
   *
   * @param id unique within the RUIC
   * @param type id of its type
   */
  record UicSpec(String id, String type) {
    /**
     * The views of a layout, each with the id of its type.
     *
     * @param layout where they lie
     * @param placeless views that have no place in a window, such as those for terminals
     * @return all of them
     */
    public static List<UicSpec> of(Layout layout, String... placeless) {
      return Stream.concat(layout.views().stream(), Stream.of(placeless)).map(id -> new UicSpec(id, id)).toList();
    }
  }
}
