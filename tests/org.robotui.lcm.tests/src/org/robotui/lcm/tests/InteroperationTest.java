package org.robotui.lcm.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Our client with the stock clients of C and Java by multicast. */
class InteroperationTest {

  private static final Pattern RECEIVED = Pattern.compile("received (\\d+) bad (\\d+)");
  private static final String LARGE_BUFFER = "&recv_buf_size=16777216";

  private static final Path BUFFER_LIMIT = Path.of("/proc/sys/net/core/rmem_max");
  private static final long ENOUGH = 4L << 20;

  private LcmWorld world;

  @BeforeEach
  void start() throws Exception {
    LcmInstallation.assumeThere();
    world = new LcmWorld();
    world.ownNetwork();
  }

  @AfterEach
  void stop() throws Exception {
    if (world != null) {
      world.close();
    }
  }

  private static int whole(Peer receiver) {
    Matcher received = RECEIVED.matcher(receiver.awaitLine("received ").output());
    assertTrue(received.find(), receiver.output());
    assertEquals("0", received.group(2), receiver.output());
    return Integer.parseInt(received.group(1));
  }

  /** At one go, as the kernel gives such a file once. */
  private static long bufferLimit() throws IOException {
    try (BufferedReader limit = Files.newBufferedReader(BUFFER_LIMIT)) {
      return Long.parseLong(limit.readLine());
    }
  }

  private static Peer sent(Peer sender) throws Exception {
    sender.tell("go");
    return sender.awaitLine("sent ");
  }

  /**
   * In one datagram, in just one, in two, and in more: with pauses, as the stock client in Java asks for no larger
   * buffer.
   */
  private static String[] send(int count) {
    return new String[]{LcmWorld.GROUP, "send", "DATA_1", "1,65493,65494,65495,65496,130974,100000",
        Integer.toString(count), "30000"};
  }

  private static String[] receive() {
    return new String[]{LcmWorld.GROUP + LARGE_BUFFER, "receive", "DATA_.*"};
  }

  @Test
  void weHearTheStockClientInC() throws Exception {
    Peer receiver = world.ours(receive());
    sent(world.stockC(send(21)));
    assertEquals(21, whole(receiver), receiver.output());
    assertTrue(receiver.output().contains("missing 0"), receiver.output());
  }

  @Test
  void weHearTheStockClientInJava() throws Exception {
    Peer receiver = world.ours(receive());
    sent(world.stockJava(send(21)));
    assertEquals(21, whole(receiver), receiver.output());
    assertTrue(receiver.output().contains("missing 0"), receiver.output());
  }

  /**
   * As from a camera or a lidar: each message is more than a dozen datagrams at once. The C client beside ours tells
   * whether it was the machine.
   */
  @Test
  void nothingIsLostOfLargeMessagesAtAPace() throws Exception {
    long limit = bufferLimit();
    assumeTrue(limit >= ENOUGH,
        "the kernel grants receive buffers of " + limit + " bytes only (net.core.rmem_max), this takes " + ENOUGH);
    Peer ours = world.ours(receive());
    Peer stock = world.stockC(receive());
    sent(world.stockC(LcmWorld.GROUP, "send", "DATA_1", "1000000", "60", "50000"));
    String both =
        "ours: " + ours.awaitLine("received ").output() + "\nthe client in C: " + stock.awaitLine("received ").output();
    assertEquals(60, whole(ours), both);
    assertTrue(ours.output().contains("missing 0"), both);
  }
}
