package org.robotui.rfic.recording.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.rfic.recording.internal.SmallRecording.time;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.replay.TimeRange;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.data.navigation.Odometry;
import org.robotui.recording.RecordingException;
import org.robotui.testkit.FakeRficContext;

class HistoryTest {
  private static final int EACH = 3000;
  private static final Map<String, Object> STANDING = Map.of("play", false);

  @TempDir
  private Path folder;
  private final PlayBench bench = new PlayBench();
  private Path file;

  /** Two topics in turn, each second; a message of the first that cannot be read, and a topic that nobody can read. */
  @BeforeEach
  void record() throws RecordingException {
    file = folder.resolve("run.mcap");
    try (SmallRecording recording = new SmallRecording(file)) {
      for (int i = 0; i < EACH; i++) {
        recording.odometry("/a", i, i).odometry("/b", i + 0.5, -i);
      }
      recording.say("/a", SmallRecording.ODOMETRY, Map.of(), EACH, Map.of("header",
          Map.of("frame_id", "odom"), "pose", Map.of("pose", Map.of("position", Map.of("x", Double.NaN)))));
      recording.raw("/odd", "msgpack", 3, new byte[]{1, 2, 3});
    }
  }

  @AfterEach
  void close() {
    bench.close();
  }

  private static final class Taken implements HistoryTaker {
    private final List<RecordedValue> values = new ArrayList<>();
    private final List<String> complaints = new ArrayList<>();
    private final List<Long> reached = new ArrayList<>();
    private int most = Integer.MAX_VALUE;

    @Override
    public void take(RecordedValue value) {
      values.add(value);
    }

    @Override
    public void unreadable(String port, String reason) {
      complaints.add(port + ": " + reason);
    }

    @Override
    public boolean reached(long time) {
      reached.add(time);
      return reached.size() < most;
    }

    private List<Double> places(String port) {
      return values.stream().filter(each -> each.port().equals(port))
          .map(each -> ((Odometry) each.value()).pose().translation().x()).toList();
    }
  }

  private static TimeRange range(double from, double to) {
    return new TimeRange(time(from), time(to));
  }

  @Test
  void pastAndFutureOfSeveralPortsComeInOrder() throws Exception {
    FakeRficContext context = bench.open(file, STANDING);
    bench.seek(1500);
    StreamHistory history = context.histories.get("a");
    assertSame(history, context.histories.get("b"));
    assertSame(bench.timeline, history.timeline());
    assertEquals(EACH + 1, history.count("a"));
    assertEquals(0, history.count("nothing"));
    assertEquals(range(0, EACH), history.span());
    Taken taken = new Taken();
    history.read(Set.of("a", "b", "nothing"), history.span(), taken);
    assertEquals(2 * EACH, taken.values.size());
    for (int i = 0; i < 2 * EACH; i++) {
      RecordedValue value = taken.values.get(i);
      assertEquals(time(i / 2.0), value.time());
      assertEquals(i % 2 == 0 ? "a" : "b", value.port());
      assertEquals(Optional.of(new Stamp(value.time(), ClockKind.SIMULATED)), value.stamp());
    }
    assertEquals(1, taken.complaints.size(), taken.complaints.toString());
    assertTrue(taken.complaints.getFirst().startsWith("a: "), taken.complaints.toString());
    assertEquals(time(EACH), taken.reached.getLast());
    assertTrue(taken.reached.size() >= 3, taken.reached.toString());
    assertEquals(taken.reached.stream().sorted().toList(), taken.reached);
    assertTrue(context.published.get("a").isEmpty(), "nothing of it is published");
  }

  @Test
  void aRangeHasBothItsEnds() throws Exception {
    StreamHistory history = bench.open(file, STANDING).histories.get("a");
    Taken taken = new Taken();
    history.read(Set.of("a"), range(5, 7), taken);
    assertEquals(List.of(5.0, 6.0, 7.0), taken.places("a"));
  }

  @Test
  void whoWantsNoMoreIsGivenNoMore() throws Exception {
    StreamHistory history = bench.open(file, STANDING).histories.get("a");
    Taken taken = new Taken();
    taken.most = 2;
    history.read(Set.of("a", "b"), history.span(), taken);
    assertEquals(2, taken.reached.size());
    assertTrue(taken.values.size() < 2 * EACH, taken.values.size() + " values");
    Thread.currentThread().interrupt();
    assertThrows(InterruptedException.class, () -> history.read(Set.of("a"), history.span(), new Taken()));
    assertFalse(Thread.currentThread().isInterrupted());
    Taken more = new Taken();
    history.read(Set.of("a"), range(1, 1), more);
    assertEquals(List.of(1.0), more.places("a"), "an interrupt has closed nothing");
  }

  @Test
  void aRecordingThatIsClosedEndsItsReadings() {
    StreamHistory history = bench.open(file, STANDING).histories.get("a");
    AtomicInteger count = new AtomicInteger();
    assertThrows(IOException.class, () -> history.read(Set.of("a"), history.span(), value -> {
      if (count.getAndIncrement() == 0) {
        bench.close();
      }
    }));
    assertTrue(count.get() < EACH, count + " values");
  }

  @Test
  void timesAreThoseOfTheRecordingWhereverItLies() throws Exception {
    FakeRficContext context = bench.open(file, Map.of("play", false, "offset", 100.0));
    StreamHistory history = context.histories.get("a");
    assertEquals(100_000_000_000L, history.offset());
    bench.timeline.shift(bench.timeline.tracks().getFirst().id(), 7);
    assertEquals(7, history.offset());
    Taken taken = new Taken();
    history.read(Set.of("a"), range(5, 5), taken);
    assertEquals(time(5), taken.values.getFirst().time());
  }

  @Test
  void whatNobodyCanReadIsTold() throws Exception {
    FakeRficContext context = bench.open(file, STANDING);
    Taken taken = new Taken();
    context.histories.get("odd").read(Set.of("odd"), range(0, 10), taken);
    assertEquals(List.of(), taken.values);
    assertTrue(taken.complaints.getFirst().contains("msgpack"), taken.complaints.toString());
  }
}
