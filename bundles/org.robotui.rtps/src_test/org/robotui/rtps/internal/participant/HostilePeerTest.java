package org.robotui.rtps.internal.participant;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ParticipantLimits;
import org.robotui.rtps.Participant;
import org.robotui.rtps.ParticipantSettings;
import org.robotui.rtps.InitialPeer;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reader;
import org.robotui.rtps.Sample;
import org.robotui.rtps.Writer;
import org.robotui.rtps.internal.discovery.EndpointCodec;
import org.robotui.rtps.internal.wire.InlineQos;
import org.robotui.rtps.internal.wire.Recorded;
import org.robotui.rtps.internal.wire.SequenceSet;
import org.robotui.rtps.internal.wire.Submessage;
import org.robotui.testkit.ByteMutator;
import org.robotui.testkit.Effort;
import org.slf4j.LoggerFactory;

/** A peer that means no good: what it costs is bounded, and an honest one is heard before, meanwhile and afterwards. */
class HostilePeerTest {

  private static final int DOMAIN = 122 + (int) (ProcessHandle.current().pid() % 8);

  private static final String TOPIC = "rt/topic";

  private static final long MEGABYTE = 1 << 20;

  /** Longer ones do not fit into a datagram once they are mutated. */
  private static final int MOST_BYTES = 60_000;

  /** Small, so that what is beyond them is seen soon. */
  private static final ParticipantLimits LIMITS = new ParticipantLimits(100, 200, 8 << 20, 8 << 20, 4 << 20);

  /** Longer than a busy machine may leave a thread without a processor: what is tested is not the lease. */
  private static final Duration LEASE = Duration.ofSeconds(60);

  private static final Duration PERIOD = Duration.ofSeconds(1);

  private static final GuidPrefix BAD = FakePeer.prefix(1);

  private static final ByteBuffer NO_QOS = ByteBuffer.allocate(0);

  private final Queue<Sample> heard = new ConcurrentLinkedQueue<>();

  private Participant victim;

  private Participant honest;

  private Writer writer;

  private Reader reader;

  private FakePeer bad;

  private long before;

  private int said;

  @BeforeEach
  void anHonestPeerIsHeardAndABadOneIsThere() throws Exception {
    ParticipantSettings settings =
        ParticipantSettings.standard(DOMAIN, "victim").withLimits(LIMITS).withLease(LEASE, PERIOD);
    victim = Participant.open(settings.withPeers(false, List.of()), Thread.ofPlatform().daemon().factory());
    int port = victim.info().metatraffic().unicast().getFirst().port();
    honest = Participant.open(ParticipantSettings.standard(DOMAIN, "honest").withLease(LEASE, PERIOD).withPeers(false,
        List.of(new InitialPeer("127.0.0.1", OptionalInt.of(port)))), Thread.ofPlatform().daemon().factory());
    reader = victim.reader(TOPIC, "type", Qos.reliable(10), NO_QOS, heard::add);
    writer = honest.writer(TOPIC, "type", Qos.reliable(1000).keepAll(), NO_QOS);
    bad = new FakePeer(victim.info());
    eventually(() -> writer.matched().size() == 1 && reader.matched().size() == 1);
    honestIsHeard();
    before = used();
  }

  @AfterEach
  void close() {
    bad.close();
    honest.close();
    victim.close();
  }

  private static void eventually(BooleanSupplier condition) throws InterruptedException {
    for (long end = System.nanoTime() + 15_000_000_000L; !condition.getAsBoolean();) {
      assertTrue(System.nanoTime() < end, "did not happen within 15 s");
      Thread.sleep(10);
    }
  }

  private static long used() {
    System.gc();
    System.gc();
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }

  private void say() {
    said++;
    writer.write(ByteBuffer.allocate(8).putInt(0x00010000).putInt(said).flip());
  }

  private long heardOfHonest() {
    return heard.stream().filter(sample -> sample.writer().prefix().equals(honest.info().guid().prefix())).count();
  }

  private void honestIsHeard() throws InterruptedException {
    for (int i = 0; i < 20; i++) {
      say();
    }
    eventually(() -> heardOfHonest() == said);
  }

  private void costsAtMost(long megabytes) {
    heard.removeIf(sample -> sample.writer().prefix().equals(BAD));
    long more = used() - before;
    assertTrue(more < megabytes * MEGABYTE, more / MEGABYTE + " MB more are used");
  }

  /** The bad one is matched like any other, and says nothing yet. */
  private EntityId badWriter(Reader to) throws InterruptedException {
    bad.participant(BAD, "bad", Duration.ofSeconds(100));
    eventually(() -> victim.discovery().participant(BAD).isPresent());
    EntityId entity = bad.writer(BAD, to == reader ? 1 : 2, to.info().topic(), to.info().qos(), 0);
    eventually(() -> {
      bad.repeat(BAD);
      return to.matched().stream().anyMatch(each -> each.guid().prefix().equals(BAD));
    });
    return entity;
  }

  /** What the recorded programs write and read, so that what they say reaches readers and writers here. */
  private void endpointsOfTheRecordedPrograms() {
    for (Qos qos : List.of(Qos.reliable(10), Qos.bestEffort(10))) {
      for (String topic : List.of("rt/chatter", "rt/latched")) {
        victim.reader(topic, "std_msgs::msg::dds_::String_", qos, NO_QOS, sample -> {});
      }
      victim.reader("rt/blob", "test::Blob_", qos, NO_QOS, sample -> {});
      victim.reader("rt/image", "sensor_msgs::msg::dds_::Image_", qos, NO_QOS, sample -> {});
    }
    Writer ours = victim.writer("rt/chatter", "std_msgs::msg::dds_::String_", Qos.reliable(10), NO_QOS);
    ours.write(ByteBuffer.allocate(8).putInt(0x00010000).flip());
  }

  private void honestIsHeardAnew() throws InterruptedException {
    honestIsHeard();
    heard.clear();
    said = 0;
  }

  @Test
  void damaged_messages_of_all_kinds() throws Exception {
    badWriter(reader);
    endpointsOfTheRecordedPrograms();
    ByteMutator mutator = new ByteMutator(Effort.seed() + 7);
    List<byte[]> good =
        Stream.of(Recorded.values()).flatMap(vendor -> vendor.toAll(MOST_BYTES, DOMAIN).stream()).toList();
    for (Effort effort = Effort.of(10_000, Duration.ofMinutes(5)); effort.goesOn();) {
      bad.raw(mutator.mutate(good.get(mutator.random().nextInt(good.size()))));
      if (effort.rounds() % 500 == 0) {
        honestIsHeardAnew();
      }
    }
    honestIsHeard();
    costsAtMost(30);
    assertTrue(victim.statistics().damaged() > 100, victim.statistics()::toString);
    LoggerFactory.getLogger(HostilePeerTest.class).info("{}", victim.statistics());
  }

  private static Submessage.DataFrag fragment(EntityId from, long sequence, long first, long sampleSize, int bytes) {
    return new Submessage.DataFrag(EntityId.UNKNOWN, from, sequence, first, 1, bytes, sampleSize, NO_QOS, false,
        ByteBuffer.allocate(bytes));
  }

  @Test
  void fragments_of_ever_new_samples_that_claim_to_be_large() throws Exception {
    Reader loose = victim.reader("rt/loose", "type", Qos.bestEffort(1), NO_QOS, heard::add);
    for (Reader each : List.of(loose, reader)) {
      EntityId from = badWriter(each);
      for (int i = 1; i < Effort.rounds(6_000); i++) {
        bad.user(BAD, fragment(from, i, 1 + i % 3, 8_000_000, 1000));
        bad.user(BAD, fragment(from, i, 1, 0xffff_fff0L, 1000));
        if (i % 500 == 0) {
          say();
        }
      }
      honestIsHeard();
      costsAtMost(30);
    }
  }

  @Test
  void numbers_that_jump_and_lie() throws Exception {
    EntityId from = badWriter(reader);
    long far = 1L << 61;
    for (int i = 1; i < 3000; i++) {
      bad.user(BAD, data(from, i));
      bad.user(BAD, data(from, far + 2L * i));
      bad.user(BAD, new Submessage.Heartbeat(EntityId.UNKNOWN, from, 1, far + i, i, false, false));
      bad.user(BAD, new Submessage.Gap(EntityId.UNKNOWN, from, 1 + i * 3L, SequenceSet.none(far + i)));
      bad.user(BAD, new Submessage.AckNack(EntityId.UNKNOWN, from, SequenceSet.none(far), i, false));
      bad.user(BAD, fragment(from, far - i, 1, 5000, 1000));
      if (i % 100 == 0) {
        say();
      }
    }
    honestIsHeard();
    costsAtMost(30);
    assertEquals(2, reader.matched().size());
  }

  private static Submessage.Data data(EntityId from, long sequence) {
    return new Submessage.Data(EntityId.UNKNOWN, from, sequence, NO_QOS, Submessage.Content.SAMPLE,
        ByteBuffer.wrap(new byte[1000]));
  }

  @Test
  void endpoints_without_end() throws Exception {
    bad.participant(BAD, "bad", Duration.ofSeconds(100));
    eventually(() -> victim.discovery().participant(BAD).isPresent());
    for (int i = 1; i < Effort.rounds(4_000); i++) {
      bad.writer(BAD, i, TOPIC + i % 7, Qos.reliable(1), 5000);
      if (i % 200 == 0) {
        say();
        Thread.sleep(1);
      }
    }
    honestIsHeard();
    costsAtMost(30);
    long known = victim.discovery().endpoints().stream().filter(it -> it.guid().prefix().equals(BAD)).count();
    assertTrue(known > 0 && known <= LIMITS.endpoints(), known + " endpoints");
  }

  @Test
  void thousands_of_participants() throws Exception {
    long sent = victim.statistics().sent();
    for (int i = 2; i < Effort.rounds(4_000); i++) {
      bad.participant(FakePeer.prefix(i), "one of many", Duration.ofDays(1000));
      if (i % 200 == 0) {
        say();
        Thread.sleep(1);
      }
    }
    honestIsHeard();
    costsAtMost(30);
    int known = victim.discovery().participants().size();
    assertTrue(known > 1 && known <= LIMITS.participants() / 4, known + " participants");
    long more = victim.statistics().sent() - sent;
    assertTrue(more < 4000, more + " datagrams were sent to them");
    Thread.sleep(3000);
    sent = victim.statistics().sent();
    Thread.sleep(1000);
    more = victim.statistics().sent() - sent;
    assertTrue(more < 10L * known, more + " datagrams a second are sent to them while they are silent");
  }

  @Test
  void somebody_who_says_that_the_honest_one_is_gone() throws Exception {
    bad.participant(BAD, "bad", Duration.ofSeconds(100));
    eventually(() -> victim.discovery().participant(BAD).isPresent());
    ByteBuffer key = EndpointCodec.writeKey(honest.info().guid(),
        ByteOrder.LITTLE_ENDIAN);
    bad.discovery(BAD, new Submessage.Data(EntityId.UNKNOWN, new EntityId(0x000100c2), 2,
        new InlineQos(true, true, Optional.empty(),
            Optional.of(honest.info().guid())).bytes(ByteOrder.LITTLE_ENDIAN),
        Submessage.Content.KEY, key));
    Thread.sleep(100);
    honestIsHeard();
    assertTrue(victim.discovery().participant(honest.info().guid().prefix()).isPresent());
  }
}
