package org.robotui.rtps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executors;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** With Fast DDS (rclpy) and Cyclone DDS, in both directions and both orders of start. */
class RealPeersTest {

  private static final Duration SOON = Duration.ofSeconds(30);
  private static final int DOMAIN = 130 + (int) (ProcessHandle.current().pid() % 20);
  private static final Qos RELIABLE = Qos.reliable(100);

  private final Heard heard = new Heard();

  private static Participant participant() throws IOException {
    return Participant.open(ParticipantSettings.standard(DOMAIN, "test").withPeers(false, List.of()),
        Executors.defaultThreadFactory());
  }

  private static RealPeer peer(RealPeer.Vendor vendor, String... qos) throws IOException, InterruptedException {
    assumeTrue(vendor.python().isPresent(), vendor + " is not installed (ROBOTUI_ROS2_PEERS)");
    return new RealPeer(vendor, DOMAIN, qos);
  }

  private Reader reader(Participant of, Qos qos) {
    return of.reader("rt/from_peer", Heard.TYPE, qos, Heard.NOTHING, heard);
  }

  private static Writer writer(Participant of, Qos qos) {
    return of.writer("rt/to_peer", Heard.TYPE, qos, Heard.NOTHING);
  }

  private static void awaitMatched(Endpoint... ends) throws InterruptedException {
    awaitMatchedBeside(Set.of(), ends);
  }

  private static void awaitMatchedBeside(Set<Guid> known, Endpoint... ends) throws InterruptedException {
    for (Endpoint each : ends) {
      Heard.await(SOON, () -> !known.containsAll(matched(each)), () -> each.info().topic() + ": " + each.mismatches());
    }
  }

  private static Set<Guid> matched(Endpoint... ends) {
    return Stream.of(ends).flatMap(end -> end.matched().stream()).map(EndpointInfo::guid).collect(Collectors.toSet());
  }

  private static List<String> words(String prefix, int count) {
    return IntStream.rangeClosed(1, count).mapToObj(i -> prefix + i).toList();
  }

  private void exchange(RealPeer peer, Reader reader, Writer writer, int count, int size) throws Exception {
    awaitMatched(reader, writer);
    peer.meet(1, 1);
    peer.write(count, size, 0.02);
    for (int i = 1; i <= count; i++) {
      writer.write(Heard.string("j" + i + " " + "y".repeat(size)));
      Thread.sleep(20);
    }
    Heard.await(SOON, () -> heard.samples().size() >= count, () -> heard.words() + " of " + count);
    Heard.await(SOON, () -> peer.heard().size() >= count, peer::toString);
    assertEquals(words("p", count), heard.words());
    assertEquals(words("j", count), peer.heard());
  }

  @ParameterizedTest
  @EnumSource
  void reliableBothWaysWhereThePeerIsFirst(RealPeer.Vendor vendor) throws Exception {
    try (RealPeer peer = peer(vendor, "reliable", "volatile", "100"); Participant us = participant()) {
      exchange(peer, reader(us, RELIABLE), writer(us, RELIABLE), 50, 10);
    }
  }

  @ParameterizedTest
  @EnumSource
  void bestEffortBothWaysWhereWeAreFirst(RealPeer.Vendor vendor) throws Exception {
    try (Participant us = participant()) {
      Reader reader = reader(us, Qos.bestEffort(10));
      Writer writer = writer(us, Qos.bestEffort(10));
      try (RealPeer peer = peer(vendor, "best_effort", "volatile", "100")) {
        exchange(peer, reader, writer, 20, 10);
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void imagesOfAMebibyteBothWays(RealPeer.Vendor vendor) throws Exception {
    try (RealPeer peer = peer(vendor, "reliable", "volatile", "20"); Participant us = participant()) {
      exchange(peer, reader(us, Qos.reliable(20)), writer(us, Qos.reliable(20)), 10, 1 << 20);
      assertEquals((1 << 20) + 3, Heard.text(heard.samples().getFirst().payload()).length());
    }
  }

  @ParameterizedTest
  @EnumSource
  void whatWasWrittenBeforeComesLater(RealPeer.Vendor vendor) throws Exception {
    Qos latched = Qos.reliable(5).with(Durability.TRANSIENT_LOCAL);
    try (Participant us = participant()) {
      Writer writer = writer(us, latched);
      for (int i = 1; i <= 8; i++) {
        writer.write(Heard.string("j" + i));
      }
      try (RealPeer peer = peer(vendor, "reliable", "transient_local", "5")) {
        peer.write(8, 10, 0.01);
        Heard.await(SOON, () -> !peer.said("sent 8").isEmpty(), peer::toString);
        reader(us, latched);
        Heard.await(SOON, () -> heard.samples().size() >= 5 && peer.heard().size() >= 5, peer::toString);
        assertEquals(words("p", 8).subList(3, 8), heard.words());
        assertEquals(words("j", 8).subList(3, 8), peer.heard());
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void aPeerThatCrashesIsForgottenAndOneThatComesBackIsHeard(RealPeer.Vendor vendor) throws Exception {
    List<String> reasons = new CopyOnWriteArrayList<>();
    try (Participant us = participant()) {
      us.discovery().addListener(new DiscoveryListener() {
        @Override
        public void participantLost(ParticipantInfo participant, String reason) {
          reasons.add(reason);
        }
      });
      Reader reader = reader(us, RELIABLE);
      Writer writer = writer(us, RELIABLE);
      Set<Guid> killed;
      try (RealPeer peer = peer(vendor, "reliable", "volatile", "100")) {
        awaitMatched(reader, writer);
        killed = matched(reader, writer);
        peer.kill();
      }
      try (RealPeer again = peer(vendor, "reliable", "volatile", "100")) {
        awaitMatchedBeside(killed, reader, writer);
        exchange(again, reader, writer, 5, 10);
      }
      Heard.await(SOON, () -> reader.matched().isEmpty(), () -> "" + reader.matched());
      assertTrue(
          reasons.stream().anyMatch(each -> each.startsWith("not heard for its lease")) || reader.matched().isEmpty(),
          () -> "" + reasons);
    }
  }

  @ParameterizedTest
  @EnumSource
  void deadlinesAndLivelinessAreWatchedBothWays(RealPeer.Vendor vendor) throws Exception {
    Qos watched = RELIABLE.withTimes(Duration.ofMillis(500), Qos.INFINITE)
        .with(Liveliness.MANUAL_BY_TOPIC, Duration.ofSeconds(1));
    try (RealPeer peer = peer(vendor, "reliable", "volatile", "10:500:1000"); Participant us = participant()) {
      Reader reader = reader(us, watched);
      Writer writer = writer(us, watched);
      Reader demanding = reader(us, watched.withTimes(Duration.ofMillis(100), Qos.INFINITE));
      awaitMatched(reader, writer);
      peer.meet(1, 1);
      peer.write(3, 10, 0.05);
      writer.write(Heard.string("j1"));
      Heard.await(SOON, () -> peer.said("alive 1").size() == 1, peer::toString);
      Heard.await(SOON, () -> !peer.said("late").isEmpty() && !peer.said("alive 0").isEmpty(), peer::toString);
      Heard.await(SOON, () -> keepsAlive(writer, peer), peer::toString);
      Heard.await(SOON,
          () -> reader.statistics().deadlinesMissed() > 0 && reader.statistics().livelinessLost() > 0,
          reader.statistics()::toString);
      assertEquals(List.of("the writer offers a deadline of 500 ms, the reader asks for a deadline of 100 ms"),
          demanding.mismatches().getFirst().reasons());
    }
  }

  /** For twice the lease; whether the peer has seen that, which a busy machine may prevent. */
  private static boolean keepsAlive(Writer writer, RealPeer peer) {
    writer.write(Heard.string("j"));
    int lost = peer.said("alive 0").size();
    for (int i = 0; i < 40; i++) {
      writer.assertLiveliness();
      LockSupport.parkNanos(50_000_000);
    }
    return peer.said("alive 0").size() == lost && peer.said("alive").getLast().equals("alive 1");
  }

  @ParameterizedTest
  @EnumSource
  void aReaderThatAdaptsHearsAPeerOfLessQuality(RealPeer.Vendor vendor) throws Exception {
    try (RealPeer peer = peer(vendor, "best_effort", "volatile", "10"); Participant us = participant()) {
      Reader plain = reader(us, RELIABLE);
      Reader adapting = us.adaptingReader("rt/from_peer", Heard.TYPE, RELIABLE, Heard.NOTHING, heard);
      awaitMatched(adapting);
      peer.meet(0, 1);
      peer.write(10, 10, 0.05);
      Heard.await(SOON, () -> heard.samples().size() >= 10, () -> "" + heard.words());
      assertEquals(words("p", 10), heard.words());
      assertEquals("the writer offers best effort, the reader asks for reliable",
          plain.mismatches().getFirst().reasons().getFirst());
    }
  }
}
