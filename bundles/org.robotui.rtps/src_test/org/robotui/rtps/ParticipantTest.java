package org.robotui.rtps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Participants of ours with each other, over loopback, without multicast. */
class ParticipantTest {

  /** Not that of another run of these tests on the same machine. */
  private static final int DOMAIN = 102 + (int) (ProcessHandle.current().pid() % 20);
  private static final Duration SOON = Duration.ofSeconds(30);
  private static final Qos RELIABLE = Qos.reliable(100);

  private Participant one;
  private Participant other;

  private static Participant open() throws IOException {
    ParticipantSettings settings = ParticipantSettings.standard(DOMAIN, "test").withPeers(false, List.of());
    return Participant.open(settings, Executors.defaultThreadFactory());
  }

  @BeforeEach
  void openBoth() throws IOException {
    one = open();
    other = open();
  }

  @AfterEach
  void closeBoth() {
    one.close();
    other.close();
  }

  private static Writer writer(Participant of, Qos qos) {
    return of.writer("rt/test", Heard.TYPE, qos, Heard.NOTHING);
  }

  private static Reader reader(Participant of, Qos qos, SampleListener listener) {
    return of.reader("rt/test", Heard.TYPE, qos, Heard.NOTHING, listener);
  }

  private static void awaitMatched(Endpoint... endpoints) throws InterruptedException {
    for (Endpoint each : endpoints) {
      Heard.await(SOON, () -> !each.matched().isEmpty(), () -> each.info() + " is matched with nobody");
    }
  }

  private static void awaitCount(Heard heard, int count) throws InterruptedException {
    Heard.await(SOON, () -> heard.samples().size() >= count, () -> heard.samples().size() + " of " + count);
  }

  @Test
  void samplesGoBothWaysInTheirOrder() throws InterruptedException {
    Heard there = new Heard();
    Heard here = new Heard();
    Writer to = writer(one, RELIABLE);
    Reader reads = reader(other, RELIABLE, there);
    Writer from = other.writer("rt/back", Heard.TYPE, RELIABLE, Heard.NOTHING);
    Reader back = one.reader("rt/back", Heard.TYPE, RELIABLE, Heard.NOTHING, here);
    awaitMatched(to, reads, from, back);
    for (int i = 0; i < 50; i++) {
      to.write(Heard.string("there-" + i));
      from.write(Heard.string("back-" + i));
    }
    awaitCount(there, 50);
    awaitCount(here, 50);
    assertEquals(IntStream.range(0, 50).mapToObj(i -> "there-" + i).toList(), there.words());
    assertEquals(IntStream.range(0, 50).mapToObj(i -> "back-" + i).toList(), here.words());
    assertTrue(to.awaitAcknowledged(SOON));
    Sample sample = there.samples().getFirst();
    assertEquals(to.info().guid(), sample.writer());
    assertTrue(Math.abs(sample.sourceNanos() / 1_000_000 - System.currentTimeMillis()) < 60_000, sample::toString);
  }

  @Test
  void longSamplesComeWhole() throws InterruptedException {
    Heard heard = new Heard();
    Writer writer = writer(one, RELIABLE);
    awaitMatched(reader(other, RELIABLE, heard), writer);
    String text = "x".repeat(3_000_000);
    for (int i = 0; i < 5; i++) {
      writer.write(Heard.string(i + text));
    }
    awaitCount(heard, 5);
    for (int i = 0; i < 5; i++) {
      assertEquals(i + text, Heard.text(heard.samples().get(i).payload()));
    }
  }

  @Test
  void whatAWriterKeepsComesAsIfItHadBeenCopied() throws InterruptedException {
    Heard heard = new Heard();
    Heard near = new Heard();
    Writer writer = writer(one, RELIABLE);
    Reader reader = reader(other, RELIABLE, heard);
    awaitMatched(reader, reader(one, RELIABLE, near));
    Heard.await(SOON, () -> writer.matched().size() == 2, () -> "not matched with both: " + writer.matched());
    List<Integer> sizes = List.of(12, 70_000, 1_000_000); // of which none has to be filled up
    for (int size : sizes) {
      ByteBuffer around = ByteBuffer.allocate(size + 20).put(12, (byte) 1).put(size + 10, (byte) 2);
      ByteBuffer part = around.position(11).limit(size + 11);
      writer.writeKept(part.asReadOnlyBuffer());
      assertEquals(11, part.position());
    }
    awaitCount(heard, 3);
    awaitCount(near, 3);
    for (Heard each : List.of(heard, near)) {
      for (Sample sample : each.samples()) {
        ByteBuffer payload = sample.payload();
        ByteBuffer expected = ByteBuffer.allocate(payload.remaining());
        expected.put(1, (byte) 1).put(payload.remaining() - 1, (byte) 2);
        assertEquals(expected, payload);
      }
      assertEquals(sizes, each.samples().stream().map(sample -> sample.payload().remaining()).toList());
    }
  }

  @Test
  void ownEndsHearEachOther() throws InterruptedException {
    Heard heard = new Heard();
    Writer writer = writer(one, RELIABLE.with(Durability.TRANSIENT_LOCAL));
    writer.write(Heard.string("early"));
    Reader reader = reader(one, RELIABLE.with(Durability.TRANSIENT_LOCAL), heard);
    assertEquals(List.of(writer.info()), reader.matched());
    writer.write(Heard.string("late " + "x".repeat(100_000)));
    awaitCount(heard, 2);
    assertEquals(List.of("early", "late"), heard.words());
    writer.close();
    assertEquals(List.of(), reader.matched());
  }

  @Test
  void anAnswerNamesWhatItAnswers() throws InterruptedException {
    Heard heard = new Heard();
    Writer writer = writer(one, RELIABLE);
    awaitMatched(reader(other, RELIABLE, heard), writer);
    SampleIdentity related = new SampleIdentity(other.info().guid(), 77);
    writer.write(Heard.string("answer"), related);
    awaitCount(heard, 1);
    assertEquals(Optional.of(related), heard.samples().getFirst().related());
  }

  @Test
  void whatDoesNotFitIsToldInASentence() throws InterruptedException {
    List<Mismatch> told = new CopyOnWriteArrayList<>();
    Reader reader = reader(one, RELIABLE, sample -> {});
    reader.addListener(new MatchListener() {
      @Override
      public void mismatched(Mismatch mismatch) {
        told.add(mismatch);
      }
    });
    Writer writer = writer(other, Qos.bestEffort(1));
    Heard.await(SOON, () -> !reader.mismatches().isEmpty(), () -> "no mismatch");
    Heard.await(SOON, () -> !writer.mismatches().isEmpty(), () -> "no mismatch at the writer");
    assertEquals(List.of("the writer offers best effort, the reader asks for reliable"),
        reader.mismatches().getFirst().reasons());
    Heard.await(SOON, () -> told.equals(reader.mismatches()), () -> "told: " + told);
    assertEquals(List.of(), reader.matched());
  }

  @Test
  void aReaderThatAdaptsHearsAllAndStrengthensAgain() throws InterruptedException {
    Heard heard = new Heard();
    Writer strong = writer(other, RELIABLE);
    Reader reader = one.adaptingReader("rt/test", Heard.TYPE, RELIABLE, Heard.NOTHING, heard);
    awaitMatched(reader, strong);
    assertEquals(Reliability.RELIABLE, reader.info().qos().reliability());
    Writer weak = writer(other, Qos.bestEffort(1));
    Heard.await(SOON, () -> reader.matched().size() == 2 && weak.matched().size() == 1, () -> "" + reader.matched());
    assertEquals(Reliability.BEST_EFFORT, reader.info().qos().reliability());
    weak.write(Heard.string("weak"));
    strong.write(Heard.string("strong"));
    awaitCount(heard, 2);
    assertEquals(List.of("strong", "weak"), heard.words().stream().sorted().toList());
    weak.close();
    Heard.await(SOON, () -> reader.info().qos().reliability() == Reliability.RELIABLE, () -> "" + reader.info());
  }

  @Test
  void nothingReliableIsAskedOfAWriterThatKeepsAll() throws InterruptedException {
    Writer keeps = writer(other, RELIABLE.keepAll());
    Reader reader = one.adaptingReader("rt/test", Heard.TYPE, RELIABLE, Heard.NOTHING, sample -> {});
    awaitMatched(keeps);
    Heard.await(SOON, () -> reader.info().qos().reliability() == Reliability.BEST_EFFORT, () -> "" + reader.info());
  }

  @Test
  void whoIsClosedIsForgottenAtOnceAndMayComeBack() throws Exception {
    Heard heard = new Heard();
    Reader reader = reader(one, RELIABLE, heard);
    List<String> reasons = new CopyOnWriteArrayList<>();
    awaitMatched(writer(other, RELIABLE), reader);
    reader.addListener(new MatchListener() {
      @Override
      public void unmatched(EndpointInfo remote, String reason) {
        reasons.add(reason);
      }
    });
    other.close();
    Guid gone = other.info().guid();
    Heard.await(SOON, () -> one.discovery().participants().stream().noneMatch(each -> each.guid().equals(gone)),
        () -> "still there");
    Heard.await(SOON, () -> !reasons.isEmpty(), () -> "its listeners were not told");
    assertEquals(List.of("its participant: it said farewell"), reasons);
    other = open();
    Writer again = writer(other, RELIABLE);
    awaitMatched(again, reader);
    again.write(Heard.string("again"));
    awaitCount(heard, 1);
  }

  @Test
  void closingEndsThreadsAndWhatIsClosedRefuses() {
    Writer writer = writer(one, RELIABLE);
    Reader reader = reader(one, RELIABLE, sample -> {});
    assertTimeoutPreemptively(Duration.ofSeconds(1), () -> one.close());
    assertTrue(writer.write(Heard.string("late")).isEmpty());
    reader.close();
    assertThrows(IllegalStateException.class, () -> writer(one, RELIABLE));
    assertFalse(Thread.getAllStackTraces().keySet().stream().filter(each -> each.getName().startsWith("rtps test"))
        .count() > 2, "only those of the other participant are left");
  }

  @Test
  void aListenerThatThrowsIsCountedAndHearsMore() throws InterruptedException {
    Heard heard = new Heard();
    Reader reader = reader(other, RELIABLE, sample -> {
      heard.received(sample);
      throw new IllegalStateException("on purpose");
    });
    Writer writer = writer(one, RELIABLE);
    awaitMatched(reader, writer);
    writer.write(Heard.string("a"));
    writer.write(Heard.string("b"));
    awaitCount(heard, 2);
    Heard.await(SOON, () -> reader.statistics().listenerErrors() == 2, () -> "" + reader.statistics());
  }

  @Test
  void aSampleThatIsTooLongIsRefused() {
    Writer writer = writer(one, RELIABLE);
    ByteBuffer huge = ByteBuffer.allocate(ParticipantLimits.standard().sampleBytes() + 1);
    assertThrows(IllegalArgumentException.class, () -> writer.write(huge));
  }
}
