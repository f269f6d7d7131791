package org.robotui.ruic.manipulator.internal;

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

class ManipulatorTypeTest {
  private final ManipulatorType type = new ManipulatorType();
  private final Settings settings = new Settings(type.schema(), Map.of());

  @Test
  void everyWindowViewHasExactlyOnePlace() {
    List<String> placed = type.layout(settings).views();

    assertEquals(placed.size(), Set.copyOf(placed).size());
    assertEquals(Stream.concat(placed.stream(), Stream.of("sound", "text")).toList(), type.uics(settings).stream().map(UicSpec::id).toList());
  }

  @Test
  void jointsAndTheirPictureAreSeenTogetherInMostOfTheWindow() {
    Split split = (Split) type.layout(settings);
    double all = split.weights().stream().mapToDouble(w -> w).sum();

    Split main = (Split) split.parts().getFirst();
    assertEquals(List.of("jointcontrol", "scene3d"), main.parts().stream().map(part -> part.views().getFirst()).toList());
    assertTrue(split.weights().getFirst() > all / 2);
  }

  @Test
  void aTerminalGetsATextView() {
    assertTrue(type.uics(settings).contains(new UicSpec("text", "text")));
  }
}
