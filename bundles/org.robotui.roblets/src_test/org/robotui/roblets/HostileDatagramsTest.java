package org.robotui.roblets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.IntFunction;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.roblets.body.BodyEntry;
import org.robotui.roblets.body.Bodymap;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;
import org.robotui.roblets.tree.BodyPath;
import org.robotui.roblets.watch.BodyWatchListener;
import org.robotui.roblets.watch.BodyWatcher;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.roblets.wire.DatagramKind;
import org.robotui.roblets.wire.RobletForm;
import org.robotui.roblets.wire.RobletStatus;
import org.robotui.testkit.ByteMutator;

/** Whatever comes to a brain: its roblets are heard all the while, and nothing grows without end. */
@Timeout(120)
class HostileDatagramsTest {
  private static final BodyPath BEAT = BodyPath.parse("heart/heartBeat/@beat");

  private final TestBody body = new TestBody();
  private final DatagramSocket hostile = new DatagramSocket(0, InetAddress.getLoopbackAddress());

  HostileDatagramsTest() throws IOException {
    // both begin in their fields
  }

  @BeforeEach
  void begin() throws IOException {
    body.run(() -> new RobletLifeTest.Heart(new AtomicLong(), new AtomicBoolean()));
    body.await("it is heard", () -> beat() > 1);
  }

  @AfterEach
  void end() {
    hostile.close();
    body.close();
  }

  private long beat() {
    return (long) body.brain().bodymap().snapshot().number(BEAT).orElse(0);
  }

  private void goesOn() {
    long now = beat();
    body.await("it is heard after all", () -> beat() > now + 3);
  }

  private void send(byte[] bytes) throws IOException {
    hostile.send(new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), body.brain().port()));
  }

  private static byte[] datagram(DatagramKind kind, String from, long sequence, BodyElement said) {
    return new BodyDatagram(kind, from, 1, sequence, 0, "brain", Optional.of(said)).bytes();
  }

  private static BodyElement form(String name) {
    return new RobletForm(name, 1, List.of(), List.of(new BodyForm("turn", "", List.of())), List.of()).element();
  }

  @Test
  void mutated_huge_and_deep_datagrams_harm_nobody() throws IOException {
    ByteMutator mutator = new ByteMutator(Long.getLong("robotui.seed", 11));
    List<byte[]> good = List.of(datagram(DatagramKind.BEACON, "gps", 1, form("gps")),
        datagram(DatagramKind.WATCH, "me", 1, BodyElement.of("watch")),
        datagram(DatagramKind.MESSAGE, "gps", 2, BodyElement.of("fix").with("lat", 1)),
        datagram(DatagramKind.REQUEST, "me", 2, BodyElement.of("turn")));
    for (int i = 0; i < 2000; i++) {
      send(mutator.mutate(good.get(i % good.size())));
    }
    send(new byte[65_000]);
    send(new byte[0]);
    send("<a>".repeat(15_000).getBytes(StandardCharsets.UTF_8));
    send("<!DOCTYPE a [<!ENTITY b 'c'><!ENTITY d '&b;&b;'>]><a>&d;</a>".getBytes(StandardCharsets.UTF_8));
    goesOn();
  }

  @Test
  void nobody_speaks_for_another_and_many_are_too_many() throws IOException {
    send(datagram(DatagramKind.MESSAGE, "heart", 999_999_999, BodyElement.of("heartBeat").with("beat", -5)));
    flood(i -> datagram(DatagramKind.MESSAGE, "stranger" + i, 1, BodyElement.of("fix")));
    flood(i -> datagram(DatagramKind.BEACON, "roblet" + i, 1, form("roblet" + i)));
    flood(i -> datagram(DatagramKind.MESSAGE, "roblet0", 2 + i, BodyElement.of("message" + i)));
    goesOn();
    assertTrue(body.brain().bodymap().history("heart", "heartBeat").stream()
        .noneMatch(e -> e.element().needed("beat") < 0));
    assertTrue(body.brain().roblets().size() <= Bodymap.MOST_ROBLETS);
    assertFalse(body.brain().bodymap().snapshot().parts().containsKey("stranger1"));
    body.brain().bodymap().snapshot().parts().values()
        .forEach(messages -> assertTrue(messages.size() <= Bodymap.MOST_MESSAGES));
  }

  private void flood(IntFunction<byte[]> made) throws IOException {
    for (int i = 0; i < 300; i++) {
      send(made.apply(i));
    }
  }

  @Test
  void a_watcher_is_told_what_it_wants_and_leaves_nothing() throws IOException {
    AtomicLong heard = new AtomicLong();
    AtomicLong known = new AtomicLong();
    InetSocketAddress there = new InetSocketAddress(InetAddress.getLoopbackAddress(), body.brain().port());
    BodyWatchListener listener = new BodyWatchListener() {
      @Override
      public void roster(RobletStatus status) {
        known.incrementAndGet();
      }

      @Override
      public void said(String roblet, BodyEntry entry, byte[] bytes) {
        heard.incrementAndGet();
      }
    };
    try (BodyWatcher watcher = new BodyWatcher("me", there, TestBody.THREADS, listener)) {
      body.await("the roblets are told", () -> watcher.isWelcome() && known.get() > 1);
      assertEquals(0, heard.get(), "nobody wants anything");
      watcher.want(Set.of("heart"));
      body.await("it is heard", () -> heard.get() > 3);
      assertEquals(1, body.brain().watchersOf("heart"));
      watcher.want(Set.of());
      body.await("the brain knows", () -> body.brain().watchersOf("heart") == 0);
      assertEquals(Set.of("me"), body.brain().watchers());
    }
    body.await("it is forgotten", () -> body.brain().watchers().isEmpty());
  }
}
