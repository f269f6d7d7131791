package org.robotui.rfic.foxglove.internal;

import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.robotui.message.Generation;
import org.robotui.testkit.rfic.RficContract;

/** What every robot interface keeps. */
class FoxgloveContractTest {
  @TestFactory
  Stream<DynamicTest> contract_with_a_bridge_to_ros2() {
    return contract(new BridgeDialect(Generation.ROS2));
  }

  @TestFactory
  Stream<DynamicTest> contract_with_foxgloves_schemas() {
    return contract(new SchemaDialect());
  }

  private static Stream<DynamicTest> contract(Dialect dialect) {
    return RficContract.of(() -> new FoxglovePeer(dialect)).map(check -> dynamicTest(check.name(), () -> {
      assumeTrue(check.lacking().isEmpty(), () -> check.lacking().orElse(""));
      check.run();
    }));
  }
}
