package org.robotui.rfic.lcm.internal;

import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.robotui.testkit.rfic.Peer;
import org.robotui.testkit.rfic.RficContract;

/** What every robot interface keeps. */
class LcmContractTest {
  @TestFactory
  Stream<DynamicTest> contract_through_a_server() {
    return contract(() -> new LcmPeer(new TcpqBus(), false));
  }

  @TestFactory
  Stream<DynamicTest> contract_through_a_server_with_a_guard() {
    return contract(() -> new LcmPeer(new TcpqBus(), true));
  }

  @TestFactory
  Stream<DynamicTest> contract_by_multicast() {
    return contract(() -> new LcmPeer(new UdpmBus(), false));
  }

  private static Stream<DynamicTest> contract(Callable<Peer> peers) {
    return RficContract.of(() -> made(peers)).map(check -> dynamicTest(check.name(), () -> {
      assumeTrue(check.lacking().isEmpty(), () -> check.lacking().orElse(""));
      check.run();
    }));
  }

  private static Peer made(Callable<Peer> peers) {
    try {
      return peers.call();
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }
}
