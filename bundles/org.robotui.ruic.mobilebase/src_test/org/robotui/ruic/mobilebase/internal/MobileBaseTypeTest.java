package org.robotui.ruic.mobilebase.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.api.RuicType.UicSpec;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout.Split;

class MobileBaseTypeTest {
  private final MobileBaseType type = new MobileBaseType();
  private final Settings settings = new Settings(type.schema(), Map.of());

  @Test
  void everyWindowViewHasExactlyOnePlace() {
    List<String> placed = type.layout(settings).views();

    assertEquals(placed.size(), Set.copyOf(placed).size());
    assertEquals(Stream.concat(placed.stream(), Stream.of("sound", "text")).toList(), type.uics(settings).stream().map(UicSpec::id).toList());
  }

  @Test
  void theMapHasMostOfTheWindow() {
    Split split = (Split) type.layout(settings);
    double all = split.weights().stream().mapToDouble(w -> w).sum();

    Split main = (Split) split.parts().getFirst();
    assertEquals("map", main.views().getFirst());
    assertTrue(split.weights().getFirst() > all / 2);
    assertTrue(main.weights().getFirst() > main.weights().getLast());
  }

  @Test
  void aTerminalGetsATextView() {
    assertTrue(type.uics(settings).contains(new UicSpec("text", "text")));
  }
}
