package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class NaturalOrderTest {
  @Test
  void namesWithNumbersAreOrderedAsPeopleDo() {
    assertEquals(List.of("arm_2", "Arm_10", "arm_10", "arm_10b", "leg"),
        Stream.of("leg", "arm_10b", "arm_10", "arm_2", "Arm_10").sorted(NaturalOrder.ORDER).toList());
    assertTrue(NaturalOrder.ORDER.compare("Motor 2", "motor 10") < 0);
    assertTrue(NaturalOrder.ORDER.compare("a", "B") < 0);
    assertTrue(NaturalOrder.ORDER.compare("a", "a1") < 0);
  }

  @Test
  void differentNamesAreNeverTheSame() {
    assertTrue(NaturalOrder.ORDER.compare("a01", "a1") != 0);
    assertEquals(0, NaturalOrder.ORDER.compare("", ""));
  }
}
