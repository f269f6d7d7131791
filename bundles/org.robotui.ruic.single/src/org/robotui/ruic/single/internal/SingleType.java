package org.robotui.ruic.single.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.RuicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.api.layout.Layout;

/** The interface that is one view, filling the window. */
@Component(service = RuicType.class)
public final class SingleType implements RuicType {
  private static final TextRule VIEW = TextRule.matching("the type of a view, such as map", "[A-Za-z_][A-Za-z0-9_-]*");
  private static final Schema SCHEMA = Schema.of(Setting.of("view", new ValueType.Text(VIEW), "map",
      "The type of the view to show, for example map, camera or status; its id in the configuration is the same word."));

  private static final Descriptor DESCRIPTOR = new Descriptor("single", "Single view",
      "One view that fills the window.",
      SCHEMA, List.of());

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public List<UicSpec> uics(Settings settings) {
    return List.of(new UicSpec(settings.text("view"), settings.text("view")));
  }

  @Override
  public Layout layout(Settings settings) {
    return new Layout.View(settings.text("view"));
  }
}
