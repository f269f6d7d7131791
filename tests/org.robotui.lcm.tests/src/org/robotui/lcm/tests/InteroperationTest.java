package org.robotui.lcm.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Our client with the stock clients of C and Java by multicast. */
class InteroperationTest {

  private static final Pattern RECEIVED = Pattern.compile("received (\\d+) bad (\\d+)");
  private static final String LARGE_BUFFER = "&recv_buf_size=16777216";

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

  private static Peer sent(Peer sender) throws Exception {
    sender.tell("go");
    return sender.awaitLine("sent ");
  }

  /** In one datagram, in just one, in two, and in more: with pauses, as the stock client in Java asks for no larger buffer. */
  private static String[] send(int count) {
    return new String[] {LcmWorld.GROUP, "send", "DATA_1", "1,65493,65494,65495,65496,130974,100000", Integer.toString(count), "30000"};
  }

  private static String[] receive() {
    return new String[] {LcmWorld.GROUP + LARGE_BUFFER, "receive", "DATA_.*"};
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
}
