package org.robotui.rfic.rosbridge.internal;

import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.robotui.message.Generation;
import org.robotui.testkit.rfic.RficContract;

/** What every robot interface keeps. */
class RosbridgeContractTest {
  @TestFactory
  Stream<DynamicTest> contract_with_ros1_in_json() {
    return contract(Generation.ROS1, "none");
  }

  @TestFactory
  Stream<DynamicTest> contract_with_ros2_in_its_own_bytes() {
    return contract(Generation.ROS2, "cbor-raw");
  }

  private static Stream<DynamicTest> contract(Generation generation, String compression) {
    return RficContract.of(() -> new RosbridgePeer(generation, compression))
        .map(check -> dynamicTest(check.name(), () -> {
          assumeTrue(check.lacking().isEmpty(), () -> check.lacking().orElse(""));
          check.run();
        }));
  }
}
