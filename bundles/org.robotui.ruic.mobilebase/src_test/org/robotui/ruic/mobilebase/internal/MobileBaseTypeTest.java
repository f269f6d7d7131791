package org.robotui.ruic.mobilebase.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.api.RuicType.UicSpec;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.Layout.Split;
import org.robotui.api.layout.Layout.Tabs;
import org.robotui.api.layout.Layout.View;

class MobileBaseTypeTest {
  private final MobileBaseType type = new MobileBaseType();
  private final Settings settings = new Settings(type.schema(), Map.of());

  @Test
  void everyWindowViewHasExactlyOnePlace() {
    List<String> placed = names(type.layout(settings)).toList();

    assertEquals(List.of("map", "camera", "teleop", "status"), placed);
    assertTrue(ids().containsAll(placed), "the layout names only views of the type");
  }

  @Test
  void theMapHasMostOfTheWindow() {
    Split split = (Split) type.layout(settings);
    double all = split.weights().stream().mapToDouble(w -> w).sum();

    assertEquals(new View("map"), split.parts().getFirst());
    assertTrue(split.weights().getFirst() > all / 2);
  }

  @Test
  void aTerminalGetsATextView() {
    assertTrue(type.uics(settings).contains(new UicSpec("text", "text")));
  }

  private List<String> ids() {
    return type.uics(settings).stream().map(UicSpec::id).toList();
  }

  private static Stream<String> names(Layout layout) {
    return switch (layout) {
      case View view -> Stream.of(view.uic());
      case Tabs tabs -> tabs.uics().stream();
      case Split split -> split.parts().stream().flatMap(MobileBaseTypeTest::names);
    };
  }
}
