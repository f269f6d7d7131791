package org.robotui.rfic.yarp.internal;

import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.robotui.testkit.Effort;
import org.robotui.testkit.rfic.RficContract;
import org.robotui.yarp.wire.YarpCarrier;

/** What every robot interface keeps. */
class YarpContractTest {
  @TestFactory
  Stream<DynamicTest> contract() {
    return contract(YarpCarrier.FAST_TCP);
  }

  @TestFactory
  Stream<DynamicTest> contract_by_tcp() {
    assumeTrue(Effort.isLong(), "long runs only: the suite waits a lot");
    return contract(YarpCarrier.TCP);
  }

  @TestFactory
  Stream<DynamicTest> contract_by_udp() {
    assumeTrue(Effort.isLong(), "long runs only: the suite waits a lot");
    return contract(YarpCarrier.UDP);
  }

  private static Stream<DynamicTest> contract(YarpCarrier carrier) {
    return RficContract.of(() -> new YarpPeer(carrier)).map(check -> dynamicTest(check.name(), () -> {
      assumeTrue(check.lacking().isEmpty(), () -> check.lacking().orElse(""));
      check.run();
    }));
  }
}
