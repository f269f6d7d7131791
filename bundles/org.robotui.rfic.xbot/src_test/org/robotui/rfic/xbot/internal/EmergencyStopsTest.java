package org.robotui.rfic.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.Diagnostics.Level;

class EmergencyStopsTest {
  @Test
  void allOfThemAreTold() {
    EmergencyStops stops = EmergencyStops.read("released\tcell door\npressed\tpendant\nunread\tmat\nnonsense\n\n");
    assertEquals(List.of(Level.OK, Level.ERROR, Level.ERROR),
        stops.diagnostics().items().stream().map(Diagnostics.Item::level).toList());
    assertEquals("emergency stops/pendant", stops.diagnostics().items().get(1).name());
    assertEquals(Optional.of("emergency stop 'pendant' pressed, 'mat' cannot be read, which counts as pressed:"
        + " all joints are safe. Release it, then start plugins again"), stops.reason());
  }

  @Test
  void whereNoneIsPressedThereIsNothingToSay() {
    assertEquals(Optional.empty(), EmergencyStops.read("released\tcell door").reason());
    assertEquals(Optional.empty(), EmergencyStops.read("").reason());
    assertEquals(List.of(), EmergencyStops.read("").diagnostics().items());
  }

  @Test
  void aWordThatIsNotKnownIsNotTakenForReleased() {
    assertEquals(Level.ERROR, EmergencyStops.read("fine\tcell door").diagnostics().items().getFirst().level());
  }
}
