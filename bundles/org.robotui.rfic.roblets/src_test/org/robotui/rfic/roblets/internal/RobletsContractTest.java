package org.robotui.rfic.roblets.internal;

import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.robotui.testkit.rfic.RficContract;

/** What every robot interface keeps. */
class RobletsContractTest {
  @TestFactory
  Stream<DynamicTest> contract() {
    return RficContract.of(RobletsPeer::new).map(check -> dynamicTest(check.name(), () -> {
      assumeTrue(check.lacking().isEmpty(), () -> check.lacking().orElse(""));
      check.run();
    }));
  }
}
