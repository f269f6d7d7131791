package org.robotui.api;

import java.util.List;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout;
import org.robotui.api.port.Port;

/**
 * A type of robot user interface: which views, where. It names views by type id only; core creates and connects them. A
 * configuration may replace or add views and the layout.
 */
public interface RuicType extends ComponentType {
  @Override
  default List<Port> ports() {
    return List.of();
  }

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
  record UicSpec(String id, String type) {}
}
