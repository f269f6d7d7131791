package org.robotui.rfic.smartsoft.internal;

import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.robotui.testkit.Effort;
import org.robotui.testkit.rfic.RficContract;

/** What every robot interface keeps. */
class SmartContractTest {
  @TestFactory
  Stream<DynamicTest> contract() {
    return contract(false);
  }

  @TestFactory
  Stream<DynamicTest> contract_with_a_guard() {
    assumeTrue(Effort.isLong(), "long runs only: the suite waits a lot");
    return contract(true);
  }

  private static Stream<DynamicTest> contract(boolean guard) {
    return RficContract.of(() -> new SmartPeer(guard)).map(check -> dynamicTest(check.name(), () -> {
      assumeTrue(check.lacking().isEmpty(), () -> check.lacking().orElse(""));
      check.run();
    }));
  }
}
