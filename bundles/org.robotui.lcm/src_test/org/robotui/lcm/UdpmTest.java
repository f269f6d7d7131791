package org.robotui.lcm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Multicast on loopback, between connections of ours. */
class UdpmTest {

  private static final String GROUP = "239.255.76.68";

  private final TestThreads threads = new TestThreads();
  private final List<Lcm> open = new ArrayList<>();
  private final Heard heard = new Heard();
  private int port;
  private Lcm one;
  private Lcm other;

  @BeforeEach
  void start() throws IOException {
    port = Ports.free();
    one = open("");
    other = open("");
  }

  @AfterEach
  void stop() {
    open.forEach(Lcm::close);
    threads.assertNoneLeft();
  }

  private Lcm open(String more) {
    Lcm lcm = Lcm.open(LcmUrl.of("udpm://" + GROUP + ":" + port + "?ttl=0&interface=lo" + more),
        LcmOptions.standard(threads));
    open.add(lcm);
    Eventually.await("the group: " + lcm.state(), () -> lcm.state() instanceof LcmState.Connected);
    return lcm;
  }

  @Test
  void messagesReachThoseWhoSubscribedTheSenderIncluded() throws IOException {
    Heard own = new Heard();
    one.subscribe("POSE|LASER_.*", SubscriptionOptions.direct(), own);
    Subscription subscription = other.subscribe("POSE|LASER_.*", SubscriptionOptions.direct(), heard);
    one.publish("LASER", Heard.text("not wanted"));
    one.publish("LASER_FRONT", Heard.text("scan"));
    one.publish("POSE", Heard.text(""));
    List<String> expected = List.of("LASER_FRONT=scan", "POSE=");
    Eventually.await("both messages", () -> heard.texts().equals(expected) && own.texts().equals(expected));
    assertEquals(2, subscription.received());
    assertTrue(heard.messages().getFirst().sender().matches("[0-9.]+:\\d+"), heard.messages().getFirst().sender());
    subscription.close();
    one.publish("POSE", Heard.text("later"));
    Eventually.await("the other subscription goes on", () -> own.texts().size() == 3);
    assertEquals(4, one.statistics().published());
  }

  /** Sizes around what fits into one datagram, and into several. */
  @Test
  void longMessagesComeWhole() throws IOException {
    other.subscribe("BIG", SubscriptionOptions.direct(), heard);
    int[] sizes = {0, 1, 65_494, 65_495, 65_496, 65_483, 130_974, 130_970, 130_971, 1 << 20};
    for (int size : sizes) {
      int before = heard.messages().size();
      one.publish("BIG", Heard.bytes(size, size));
      Eventually.await("a message of " + size + " bytes", () -> heard.messages().size() == before + 1);
      assertEquals(Heard.bytes(size, size), heard.messages().getLast().data(), "a message of " + size + " bytes");
    }
    assertEquals(0, other.statistics().lost() + other.statistics().incomplete() + other.statistics().damaged());
  }

  @Test
  void theReceiveBufferIsAskedForAndWhatWasGrantedIsTold() {
    Lcm small = open("&recv_buf_size=40000");
    assertEquals(40_000, small.statistics().receiveBufferWanted());
    assertEquals(40_000, small.statistics().receiveBuffer());
    LcmStatistics large = one.statistics();
    assertTrue(large.receiveBufferWanted() == 16 << 20 && large.receiveBuffer() > 100_000, large.toString());
    assertTrue(one.state().toString().contains("receive buffer " + large.receiveBuffer() + " of 16777216 bytes"),
        one.state().toString());
  }

  /** While the receiving thread is held up, the kernel's buffer runs over. */
  @Test
  void whatTheKernelDropsIsCounted() throws Exception {
    Lcm slow = open("&recv_buf_size=30000");
    CountDownLatch goOn = new CountDownLatch(1);
    slow.subscribe("DATA", SubscriptionOptions.direct(), message -> await(goOn));
    slow.subscribe("END", SubscriptionOptions.direct(), heard);
    int count = 6000; // more than wait here and in the kernel
    for (int i = 0; i < count; i++) {
      one.publish("DATA", Heard.bytes(1000, i));
    }
    goOn.countDown();
    Eventually.await("the last message", () -> {
      publish("END");
      return !heard.messages().isEmpty();
    });
    LcmStatistics figures = slow.statistics();
    assertTrue(figures.lost() > 0, figures.toString());
    long ends = one.statistics().published() - count;
    assertTrue(figures.received() + figures.lost() <= count + ends && figures.received() + figures.lost() >= count,
        figures + " of " + count);
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void publish(String channel) {
    try {
      one.publish(channel, Heard.text("x"));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void aSlowListenerWithAQueueHoldsUpNobodyAndItsDropsAreCounted() throws IOException {
    CountDownLatch goOn = new CountDownLatch(1);
    Subscription slow = other.subscribe("DATA", SubscriptionOptions.queued(5), message -> await(goOn));
    other.subscribe("DATA", SubscriptionOptions.direct(), heard);
    for (int i = 0; i < 50; i++) {
      publish("DATA");
      int expected = i + 1;
      Eventually.await("message " + i, () -> heard.messages().size() == expected);
    }
    assertTrue(slow.dropped() >= 44 && other.statistics().dropped() == slow.dropped(), "dropped " + slow.dropped());
    goOn.countDown();
    Eventually.await("the newest ones", () -> slow.received() + slow.dropped() == 50);
  }

  @Test
  void aListenerThatThrowsIsCountedAndTheOthersGoOn() {
    Subscription bad = other.subscribe("DATA", SubscriptionOptions.direct(), message -> {
      throw new IllegalStateException("on purpose");
    });
    other.subscribe("DATA", SubscriptionOptions.direct(), heard);
    publish("DATA");
    publish("DATA");
    Eventually.await("both messages", () -> heard.messages().size() == 2);
    assertEquals(2, bad.listenerErrors());
    assertEquals(2, other.statistics().listenerErrors());
  }

  @Test
  void whatIsNoLcmIsCountedWithItsSender() throws IOException {
    other.subscribe(".*", SubscriptionOptions.direct(), heard);
    try (DatagramSocket stranger = new MulticastSocket()) {
      stranger.setOption(StandardSocketOptions.IP_MULTICAST_IF, NetworkInterface.getByName("lo"));
      byte[] junk = ByteBuffer.allocate(12).putInt(0x4c433032).putInt(1).putInt(0x41414141).array();
      stranger.send(new DatagramPacket(junk, junk.length, InetAddress.getByName(GROUP), port));
      Eventually.await("the damage", () -> other.statistics().damaged() == 1);
    }
    assertTrue(other.statistics().lastDamage().matches("from [0-9.]+:\\d+: a channel has 1 to 63 bytes and a zero.*"),
        other.statistics().lastDamage());
    publish("GOOD");
    Eventually.await("the good one", () -> heard.texts().equals(List.of("GOOD=x")));
  }

  @Test
  void whatCannotBeSentIsRefusedByName() {
    assertThrows(IllegalArgumentException.class, () -> one.publish("", Heard.text("")));
    assertThrows(IllegalArgumentException.class, () -> one.publish("C".repeat(64), Heard.text("")));
    assertThrows(IllegalArgumentException.class, () -> one.publish("A\0B", Heard.text("")));
    IllegalArgumentException wrong = assertThrows(IllegalArgumentException.class,
        () -> one.subscribe("(", SubscriptionOptions.direct(), heard));
    assertTrue(wrong.getMessage().contains("'(' is no regular expression of channels"), wrong.getMessage());
    one.close();
    IOException closed = assertThrows(IOException.class, () -> one.publish("POSE", Heard.text("12")));
    assertEquals("a message of 2 bytes for POSE was not sent: closed", closed.getMessage());
    assertThrows(IllegalStateException.class, () -> one.subscribe("POSE", SubscriptionOptions.direct(), heard));
  }

  @Test
  void anInterfaceThatIsNotThereIsNamedAndTriedAgain() {
    List<LcmState> states = new CopyOnWriteArrayList<>();
    Lcm lost = Lcm.open(LcmUrl.of("udpm://" + GROUP + ":" + port + "?interface=none7"),
        LcmOptions.standard(threads).withStates(states::add));
    open.add(lost);
    Eventually.await("two attempts", () -> states.stream().filter(LcmState.Failed.class::isInstance).count() >= 2);
    LcmState.Failed failed =
        (LcmState.Failed) states.stream().filter(LcmState.Failed.class::isInstance).findFirst().orElseThrow();
    assertTrue(
        failed.reason().contains("there is no network interface 'none7', but ") && failed.reason().contains("lo"),
        failed.reason());
    IOException e = assertThrows(IOException.class, () -> lost.publish("POSE", Heard.text("")));
    assertTrue(e.getMessage().contains("POSE") && e.getMessage().contains("none7"), e.getMessage());
  }
}
