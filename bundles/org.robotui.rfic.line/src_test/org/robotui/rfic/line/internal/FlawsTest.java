package org.robotui.rfic.line.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robotui.testkit.rfic.Check;
import org.robotui.testkit.rfic.RficContract;

/** The contract of robot interfaces lets pass what keeps it, and finds what does not. */
class FlawsTest {
  @TestFactory
  Stream<DynamicTest> whatKeepsItPasses() {
    return RficContract.of(() -> new FlawedPeer(Flaw.NONE)).map(check -> dynamicTest(check.name(), () -> {
      assumeTrue(check.lacking().isEmpty(), () -> check.lacking().orElse(""));
      check.run();
    }));
  }

  @ParameterizedTest
  @EnumSource(value = Flaw.class, names = "NONE", mode = EnumSource.Mode.EXCLUDE)
  void whatDoesNotIsFound(Flaw flaw) {
    Check check =
        RficContract.of(() -> new FlawedPeer(flaw)).filter(c -> c.name().equals(flaw.found)).findFirst().orElseThrow();
    assertThrows(AssertionError.class, check::run);
  }

  @Test
  void whatIsLackingIsToldWithItsReason() {
    List<Check> lacking =
        RficContract.of(() -> new FlawedPeer(Flaw.NONE)).filter(c -> c.lacking().isPresent()).toList();
    assertEquals(List.of("leaves the robot as it was"), lacking.stream().map(Check::name).toList());
    assertEquals(Optional.of("it keeps no list"), lacking.getFirst().lacking());
  }
}
