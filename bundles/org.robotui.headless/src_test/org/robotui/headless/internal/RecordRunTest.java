package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.record.Recorder;
import org.robotui.api.record.RecorderState;
import org.robotui.api.record.RecordingChoice;
import org.robotui.api.record.RecordingOutcome;
import org.robotui.api.record.RecordingPacking;
import org.robotui.api.record.RecordingPlan;
import org.robotui.api.record.RecordingStatus;

class RecordRunTest {
  private static final Path FILE = Path.of("/data/run.mcap");
  private static final RecordingStatus STATUS = new RecordingStatus(List.of(FILE), Instant.now(), 4_000_000, 120, 3,
      List.of(new RecordingStatus.Channel("Natalie", "/scan", "sensor_msgs/msg/LaserScan", 120, 4_000_000, 3)),
      1L << 40, List.of("3 messages could not be taken in time"));

  private final ByteArrayOutputStream err = new ByteArrayOutputStream();
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final CountDownLatch stop = new CountDownLatch(1);
  private final List<RecordingPlan> plans = new ArrayList<>();
  private Optional<String> obstacle = Optional.empty();
  private String endedBy = "";
  private RecorderState state = new RecorderState(Optional.empty(), Optional.empty(), Optional.empty());

  /** Records nothing, and ends by itself where the test wants that. */
  private final class FakeRecorder implements Recorder {
    @Override
    public Optional<String> obstacle(RecordingPlan plan) {
      return obstacle;
    }

    @Override
    public RecordingOutcome start(RecordingPlan plan) {
      plans.add(plan);
      state = endedBy.isEmpty() ? new RecorderState(Optional.of(STATUS), Optional.empty(), Optional.empty()) : ended();
      return obstacle.<RecordingOutcome>map(RecordingOutcome.Refused::new)
          .orElseGet(() -> new RecordingOutcome.Done(List.of(FILE), "recording to " + FILE));
    }

    private RecorderState ended() {
      return new RecorderState(Optional.empty(), Optional.of(new RecorderState.Ended(STATUS, endedBy)),
          Optional.empty());
    }

    @Override
    public RecordingOutcome stop() {
      state = ended();
      return new RecordingOutcome.Done(List.of(FILE), "");
    }

    @Override
    public RecordingOutcome keepRecent(Duration limit, RecordingChoice choice) {
      throw new UnsupportedOperationException();
    }

    @Override
    public void forgetRecent() {
      throw new UnsupportedOperationException();
    }

    @Override
    public RecordingOutcome saveRecent(Path target) {
      throw new UnsupportedOperationException();
    }

    @Override
    public RecorderState state() {
      return state;
    }

    @Override
    public Subscription listen(Runnable listener) {
      throw new UnsupportedOperationException();
    }
  }

  private Exit run(String... words) throws Exception {
    List<String> all = new ArrayList<>(List.of("-config", "a.yaml", "-record", FILE.toString()));
    all.addAll(List.of(words));
    return new RecordRun(new FakeRecorder(), new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8), stop).run(RecordArguments.parse(all));
  }

  private String out() {
    return out.toString(StandardCharsets.UTF_8);
  }

  private String err() {
    return err.toString(StandardCharsets.UTF_8).strip();
  }

  @Test
  void whatIsChosenIsRecorded() throws Exception {
    stop.countDown();

    assertEquals(Exit.FINE, run("-robots", "Nat*", "-ports", "scan", "-ports", "odom", "-compression", "lz4",
        "-splitsize", "2000000", "-splittime", "90"));

    assertEquals(
        List.of(new RecordingPlan(FILE, new RecordingChoice(List.of("Nat*"), List.of("scan", "odom")),
            RecordingPacking.LZ4, OptionalLong.of(2_000_000), Optional.of(Duration.ofSeconds(90)))),
        plans);
    assertEquals("recording to /data/run.mcap\n"
        + "        120  /scan (sensor_msgs/msg/LaserScan), 3 dropped\n/data/run.mcap\n", out());
  }

  @Test
  void theTimeIsOverAndProgramsAreToldInLines() throws Exception {
    assertEquals(Exit.FINE, run("-json", "-for", "0.3"));

    List<String> lines = out().lines().toList();
    assertTrue(lines.getFirst().startsWith("{\"file\":\"/data/run.mcap\",\"files\":1,\"seconds\":"), out());
    assertTrue(lines.getLast().contains("\"messages\":120,\"dropped\":3,\"channels\":1,\"disk_left\":1099511627776,"
        + "\"ended\":1,"), out());
    assertEquals("3 messages could not be taken in time", err());
  }

  @Test
  void anObstacleIsTold() throws Exception {
    obstacle = Optional.of("the folder /data is not there");

    assertEquals(Exit.RECORDING, run());

    assertEquals("the folder /data is not there", err());
    assertEquals("", out());
  }

  @Test
  void whatEndsByItselfIsAFailure() throws Exception {
    endedBy = "the disk is nearly full";

    assertEquals(Exit.RECORDING, run());

    assertEquals("the disk is nearly full", err());
  }

  @Test
  void wrongWordsAreTold() {
    assertEquals("-compression is none, lz4 or zstd, not 'gzip'", wrong("-compression", "gzip"));
    assertEquals("-splitsize needs a number above 0, not 'many'", wrong("-splitsize", "many"));
    assertEquals("files of 10 bytes are too small; at least 1048576 are possible", wrong("-splitsize", "10"));
    assertEquals("unknown argument -port", wrong("-port", "scan"));
  }

  private String wrong(String... words) {
    return assertThrows(Arguments.Wrong.class, () -> run(words)).getMessage();
  }
}
