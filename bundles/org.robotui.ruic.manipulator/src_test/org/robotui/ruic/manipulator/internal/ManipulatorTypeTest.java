package org.robotui.ruic.manipulator.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.RuicType.UicSpec;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout.Split;

class ManipulatorTypeTest {
  private final ManipulatorType type = new ManipulatorType();
  private final Settings settings = new Settings(type.schema(), Map.of());

  @Test
  void jointsAndTheirPictureAreSeenTogetherInMostOfTheWindow() {
    Split split = (Split) type.layout(settings);
    double all = split.weights().stream().mapToDouble(w -> w).sum();

    Split main = (Split) split.parts().getFirst();
    assertEquals(List.of("jointcontrol", "scene3d"),
        main.parts().stream().map(part -> part.views().getFirst()).toList());
    assertTrue(split.weights().getFirst() > all / 2);
  }

  @Test
  void terminalsAndEarsGetAViewToo() {
    assertTrue(type.uics(settings).containsAll(List.of(new UicSpec("sound", "sound"), new UicSpec("text", "text"))));
  }
}
