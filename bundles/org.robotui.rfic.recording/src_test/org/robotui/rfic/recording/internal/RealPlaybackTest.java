package org.robotui.rfic.recording.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.api.config.Placed;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.RawMessage;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.TimelineState;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.ScanProgress;
import org.robotui.rfic.recording.internal.file.RecordingFiles;
import org.robotui.testkit.FakeRficContext;
import org.robotui.testkit.FakeRficContext.Published;
import org.robotui.testkit.recorded.SharedData;

/** Recordings of robots: whoever goes to a time sees what one sees who plays until then. */
@EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
class RealPlaybackTest {
  /**
   * What happens is over after a move; transforms become frames; service events have definitions that no parser knows.
   */
  private static final Set<String> UNSEEN = Set.of("rosout", "tf", "tf_static", "add_two_ints/_service_event");

  @TempDir
  private Path folder;

  static Stream<Path> files() {
    return Stream.of(SharedData.files("bags", ".bag"), SharedData.files("mcap", ".mcap"),
        SharedData.files("carmen", ".log"), SharedData.files("../captures/player", ".log")).flatMap(List::stream)
        .filter(file -> !file.endsWith("no_messages.bag"));
  }

  @ParameterizedTest
  @MethodSource("files")
  void showTheSameAtATimeWhoeverGoesThere(Path file) throws IOException {
    for (double share : new double[]{0, 0.5, 1}) {
      try (PlayBench played = new PlayBench(); PlayBench moved = new PlayBench()) {
        FakeRficContext one = open(played, file);
        TimeRange span = played.state().span().orElseThrow();
        long to = span.start() + (long) (span.length() * share);
        playUntil(played, to);
        FakeRficContext other = open(moved, file);
        moved.timeline.seek(to);
        PlayBench.await(() -> moved.state().toString(), () -> moved.state().position() == to);
        Set<String> there = recorded(file, to);
        PlayBench.await(() -> file + " at " + share + ": " + newest(one) + " but " + newest(other) + " of " + there,
            () -> newest(one).equals(newest(other)) && newest(one).keySet().equals(there));
      }
    }
  }

  /** The ports whose topics have spoken by then, but for what happens and transforms. */
  private static Set<String> recorded(Path file, long time) throws IOException {
    Set<String> ports = new TreeSet<>();
    try (RecordingReader recording = RecordingFiles.open(file, List.of(), ScanProgress.NONE)) {
      for (RecordedChannel channel : recording.channels()) {
        if (recording.latestBefore(channel.id(), time).isPresent()) {
          ports.add(channel.topic().substring(1));
        }
      }
    }
    ports.removeAll(UNSEEN);
    return ports;
  }

  /** Streams are offered one after the other behind the link: who asks earlier misses some of them. */
  private static FakeRficContext open(PlayBench bench, Path file) throws IOException {
    FakeRficContext context = bench.open(file, Map.of("play", false));
    Set<String> all = recorded(file, Long.MAX_VALUE);
    PlayBench.await(() -> context.streams.keySet() + " of " + all, () -> context.streams.keySet().containsAll(all));
    context.streams.keySet().stream().sorted().forEach(port -> context.demand(port, true));
    return context;
  }

  private static void playUntil(PlayBench bench, long time) {
    TimeRange span = bench.state().span().orElseThrow();
    bench.timeline.range(Optional.of(new TimeRange(span.start(), time)));
    bench.timeline.speed(100);
    bench.timeline.play();
    PlayBench.await(() -> bench.state().toString(), () -> {
      bench.real.addAndGet(20_000_000L);
      return !bench.state().playing() && bench.state().position() == time;
    });
  }

  /** The bytes of the newest value of each stream; what happened, such as the log, is over after a move. */
  private static Map<String, Integer> newest(FakeRficContext context) {
    Map<String, Integer> all = new TreeMap<>();
    context.published.forEach((port, values) -> {
      Published last = values.peekLast();
      if (last != null && last.raw().isPresent() && !UNSEEN.contains(port)) {
        all.put(port, hash(last.raw().get()));
      }
    });
    return all;
  }

  private static int hash(RawMessage message) {
    byte[] bytes = new byte[message.bytes().size()];
    message.bytes().buffer(ByteOrder.LITTLE_ENDIAN).get(bytes);
    return Arrays.hashCode(bytes);
  }

  /** By each port, what playing gives is the end of what is read whole: topics are taken up while it plays already. */
  @ParameterizedTest
  @MethodSource("files")
  void readingGivesWhatPlayingGives(Path file) throws Exception {
    try (PlayBench bench = new PlayBench()) {
      FakeRficContext context = open(bench, file);
      TimeRange span = bench.state().span().orElseThrow();
      playUntil(bench, span.end());
      PlayBench.await(() -> bench.state().toString(), bench.timeline::isThere);
      assertTrue(!context.histories.isEmpty());
      for (String port : new TreeSet<>(context.histories.keySet())) {
        List<String> read = new ArrayList<>();
        StreamHistory history = context.histories.get(port);
        history.read(Set.of(port), span, value -> read.add(value.stamp() + " " + hash(value.raw().orElseThrow())));
        List<String> played = context.published.get(port).stream()
            .map(each -> each.stamp() + " " + hash(each.raw().orElseThrow())).toList();
        assertTrue(played.size() <= read.size(), file + ", " + port + ": " + read.size() + " but " + played.size());
        assertEquals(read.subList(read.size() - played.size(), read.size()), played, file + ", " + port);
      }
    }
  }

  @Test
  void aRecordingThatWasCutOffIsPlayedAsFarAsItGoes() throws IOException {
    Path cut = folder.resolve("cut.bag");
    byte[] whole = Files.readAllBytes(SharedData.file("bags/sena_loop.bag"));
    Files.write(cut, Arrays.copyOf(whole, whole.length * 2 / 3));
    try (PlayBench bench = new PlayBench()) {
      FakeRficContext context = open(bench, cut);
      assertTrue(context.links.getLast() instanceof LinkState.Degraded d && d.reason().contains("damaged"),
          context.links.toString());
      assertTrue(!bench.timeline.tracks().getFirst().problems().isEmpty());
      bench.timeline.seek(Long.MAX_VALUE);
      PlayBench.await(() -> bench.state() + " " + context.published.keySet(),
          () -> !context.published.get("scan").isEmpty()
              && bench.state().position() == bench.state().span().orElseThrow().end());
    }
  }

  @Test
  void aRecordingWithoutMessagesSaysSo() {
    try (PlayBench bench = new PlayBench()) {
      FakeRficContext context = new FakeRficContext();
      bench.start(context, SharedData.file("bags/no_messages.bag"), Map.of());
      PlayBench.await(() -> context.links.toString(), () -> context.links.getLast() instanceof LinkState.Failed f
          && f.reason().contains("nothing to play"));
      assertEquals(TimelineState.EMPTY, bench.state());
    }
  }

  @Test
  void aLogOfLcmIsPlayedByItsTypesAndWithoutThemAsBytes() {
    Path log = SharedData.file("lcm/sena_loop.lcmlog");
    Map<String, Object> types = Map.of("play", false, "types", Placed.nowhere(SharedData.file("lcm/types").toString()));
    try (PlayBench typed = new PlayBench(); PlayBench raw = new PlayBench()) {
      assertTrue(atTheEnd(typed, log, types, "ODOMETRY").field("xy_theta").orElseThrow() instanceof FieldValue.Numbers n
          && Math.abs(n.values().get(1) + 21.163699) < 1e-6);
      DynamicRecord bytes = atTheEnd(raw, log, Map.of("play", false), "ODOMETRY");
      assertEquals("unknown 0xf2845346b80525ab", bytes.schema());
      assertTrue(bytes.field("remedy").orElseThrow().toString().contains("write after types:"), bytes.toString());
    }
  }

  private static DynamicRecord atTheEnd(PlayBench bench, Path file, Map<String, Object> settings, String port) {
    FakeRficContext context = bench.open(file, settings);
    context.demand(port, true);
    bench.timeline.seek(bench.state().span().orElseThrow().end());
    PlayBench.await(() -> "" + context.published.keySet(),
        () -> context.published.containsKey(port) && !context.published.get(port).isEmpty());
    return (DynamicRecord) context.published.get(port).getLast().value();
  }

  @Test
  void theTurnOfARobotIsShownAsItWas() throws IOException {
    try (PlayBench bench = new PlayBench()) {
      FakeRficContext context = open(bench, SharedData.file("bags/sena_loop.bag"));
      bench.timeline.seek(bench.state().span().orElseThrow().end());
      PlayBench.await(() -> PlayBench.last(context, "odom"),
          () -> PlayBench.last(context, "odom").contains("x=-4.80243"));
      // one topic comes after the other
      PlayBench.await(() -> context.kept + " " + context.transforms, () -> !context.published.get("map").isEmpty()
          && context.kept.getOrDefault("map", false)
          && context.transforms.stream().anyMatch(t -> t.fixed() && t.child().name().equals("laser"))
          && context.transforms.stream().anyMatch(t -> t.parent().name().equals("map")));
      assertEquals(1, context.published.get("map").stream().map(Published::value).distinct().count());
    }
  }
}
