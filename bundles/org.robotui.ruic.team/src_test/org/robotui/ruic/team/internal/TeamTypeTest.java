package org.robotui.ruic.team.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.RuicType.UicSpec;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.Layout.Split;

class TeamTypeTest {
  private final TeamType type = new TeamType();
  private final Settings settings = new Settings(type.schema(), Map.of());

  @Test
  void mapAndTableAreSeenTogether() {
    Split split = (Split) type.layout(settings);
    assertEquals("map", split.parts().getFirst().views().getFirst());
    Split side = (Split) split.parts().getLast();
    assertEquals(new Layout.View("team"), side.parts().getFirst());
    assertTrue(side.weights().getFirst() > side.weights().getLast());
  }

  @Test
  void terminalsAndEarsGetAViewToo() {
    assertTrue(type.uics(settings).containsAll(List.of(new UicSpec("sound", "sound"), new UicSpec("text", "text"))));
  }
}
