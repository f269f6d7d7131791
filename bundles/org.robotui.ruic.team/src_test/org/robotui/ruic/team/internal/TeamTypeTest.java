package org.robotui.ruic.team.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.api.RuicType.UicSpec;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.Layout.Split;

class TeamTypeTest {
  private final TeamType type = new TeamType();
  private final Settings settings = new Settings(type.schema(), Map.of());

  @Test
  void everyWindowViewHasExactlyOnePlace() {
    List<String> placed = type.layout(settings).views();
    assertEquals(placed.size(), Set.copyOf(placed).size());
    assertEquals(Stream.concat(placed.stream(), Stream.of("sound", "text")).toList(), type.uics(settings).stream().map(UicSpec::id).toList());
  }

  @Test
  void mapAndTableAreSeenTogether() {
    Split split = (Split) type.layout(settings);
    assertEquals("map", split.parts().getFirst().views().getFirst());
    Split side = (Split) split.parts().getLast();
    assertEquals(new Layout.View("team"), side.parts().getFirst());
    assertTrue(side.weights().getFirst() > side.weights().getLast());
  }
}
