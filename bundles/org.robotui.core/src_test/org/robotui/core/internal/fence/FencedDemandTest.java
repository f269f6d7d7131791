package org.robotui.core.internal.fence;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Demand;

class FencedDemandTest {
  @Test
  void whatADemandThrowsDoesNotReachWhoTellsIt() {
    List<Boolean> told = new ArrayList<>();
    Demand fenced = new FencedDemand(wanted -> {
      told.add(wanted);
      throw wanted ? new NoClassDefFoundError("for a test") : new AssertionError("for a test");
    });

    fenced.changed(true);
    fenced.changed(false);

    assertEquals(List.of(true, false), told);
  }
}
