package org.robotui.api;

import java.util.List;
import java.util.Set;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout;

/**
 * A type of robot user interface that always has the same views at the same places, and nothing to configure. A bundle
 * extends it and says in the constructor what it is: all there is to such a type is its layout.
 */
public abstract class FixedRuicType implements RuicType {
  private final Descriptor descriptor;
  private final Layout layout;
  private final List<UicSpec> views;

  /**
   * Describes the type. Each view has the id of its type as its own.
   *
   * @param id the word used in configurations
   * @param label the name that users read
   * @param help a sentence for users: what it is for
   * @param layout where the views lie
   * @param placeless ids of views that have no place in a window, such as those for terminals
   * @throws IllegalArgumentException if a view is named twice
   */
  protected FixedRuicType(String id, String label, String help, Layout layout, String... placeless) {
    this.descriptor = new Descriptor(id, label, help, Schema.EMPTY, List.of());
    this.layout = layout;
    this.views = UicSpec.of(layout, placeless);
    if (Set.copyOf(views).size() < views.size()) {
      throw new IllegalArgumentException(
          "the interface '" + id + "' names a view twice: " + views.stream().map(UicSpec::id).toList());
    }
  }

  @Override
  public final Descriptor descriptor() {
    return descriptor;
  }

  @Override
  public final List<UicSpec> uics(Settings settings) {
    return views;
  }

  @Override
  public final Layout layout(Settings settings) {
    return layout;
  }
}
