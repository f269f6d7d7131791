package org.robotui.rtps;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.time.Duration;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * What a robot that keeps all for its readers, and a witness beside us, see of a workbench that is stopped or killed.
 */
class SideEffectsTest {

  private static final Duration LONG = Duration.ofSeconds(60);
  private static final int DOMAIN = 151 + (int) (ProcessHandle.current().pid() % 10);
  private static final int COUNT = 500;
  private static final int SIZE = 20_000;
  private static final double PERIOD = 0.02;

  /** After so many seconds a writer gives up: its max_blocking_time. */
  private static final double WAITED = 0.1;

  /**
   * A witness that the machine does not let run for a tenth of a second costs a write, too. One that waits for a reader
   * that is stopped costs a hundred.
   */
  private static final int BY_THE_MACHINE = 3;

  private static List<String> run(RealPeer.Vendor vendor, String how, String signal) throws Exception {
    assumeTrue(vendor.python().isPresent(), vendor + " is not installed (ROBOTUI_ROS2_PEERS)");
    try (RealPeer robot = new RealPeer(vendor, DOMAIN, "reliable", "volatile", "all");
        RealPeer witness = RealPeer.witness(vendor, DOMAIN, "reliable", "volatile", "all")) {
      while (witness.heard().isEmpty()) { // until they know each other
        robot.write(1, SIZE, PERIOD);
        Thread.sleep(200);
      }
      robot.write(COUNT, SIZE, PERIOD);
      try (Workbench workbench = Workbench.start(DOMAIN, how)) {
        workbench.signal(signal);
        Heard.await(LONG, () -> !robot.said("sent " + COUNT).isEmpty(), robot::toString);
        Heard.await(LONG, () -> witness.heard().contains("p" + COUNT), witness::toString);
      }
      List<String> lost = IntStream.rangeClosed(2, COUNT).mapToObj(i -> "p" + i)
          .filter(each -> !witness.heard().contains(each)).toList();
      System.out.printf("%s, %s, %s: %s, %d writes failed, the witness missed %d%n", vendor, how, signal,
          robot.said("sent " + COUNT), robot.said("failed").size(), lost.size());
      assertTrue(lost.size() <= robot.said("failed").size(), () -> "the witness missed " + lost);
      return robot.said("failed");
    }
  }

  @ParameterizedTest
  @CsvSource({"CYCLONE,STOP", "CYCLONE,KILL", "FAST_DDS,STOP", "FAST_DDS,KILL"})
  void nobodyWaitsForAReaderThatAdapts(RealPeer.Vendor vendor, String signal) throws Exception {
    List<String> failed = run(vendor, "adapting", signal);
    assertTrue(failed.size() <= BY_THE_MACHINE, failed::toString);
  }

  @ParameterizedTest
  @CsvSource({"CYCLONE", "FAST_DDS"})
  void forAReliableReaderTheyWaitNoLongerThanItsLease(RealPeer.Vendor vendor) throws Exception {
    int failed = run(vendor, "reliable", "STOP").size();
    double waited = failed * WAITED;
    assertTrue(waited <= 4, () -> failed + " writes failed");
  }
}
