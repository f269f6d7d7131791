package org.robotui.rfic.carmen.internal;

import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.robotui.testkit.Effort;
import org.robotui.testkit.rfic.RficContract;

/** What every robot interface keeps. */
class CarmenContractTest {
  @TestFactory
  Stream<DynamicTest> contract() {
    return contract(false, false);
  }

  @TestFactory
  Stream<DynamicTest> contract_with_a_guard() {
    return contract(true, false);
  }

  @TestFactory
  Stream<DynamicTest> contract_with_direct_links() {
    return contract(false, true);
  }

  private static Stream<DynamicTest> contract(boolean guard, boolean direct) {
    assumeTrue(!guard && !direct || Effort.isLong(), "long runs only: the suite waits a lot");
    return RficContract.of(() -> new CarmenPeer(guard, direct)).map(check -> dynamicTest(check.name(), () -> {
      assumeTrue(check.lacking().isEmpty(), () -> check.lacking().orElse(""));
      check.run();
    }));
  }
}
