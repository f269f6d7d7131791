package org.robotui.rfic.recording.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.rfic.recording.internal.SmallRecording.time;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.RawOrigin;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline.LaneId;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.navigation.Odometry;
import org.robotui.recording.RecordingException;
import org.robotui.testkit.FakeRficContext;

class PlaybackTest {
  private static final String ODOM = "odom";
  private static final Map<String, Object> STANDING = Map.of("play", false);

  @TempDir
  private Path folder;
  private final PlayBench bench = new PlayBench();
  private Path file;

  /** Ten seconds: odometry each half second with the time as its place, a map at 3 s, transforms each 0.1 s. */
  @BeforeEach
  void record() throws RecordingException {
    file = folder.resolve("run.mcap");
    try (SmallRecording recording = new SmallRecording(file)) {
      recording.transform("/tf_static", 0, "base_link", "laser", 0.5);
      for (int i = 0; i <= 100; i++) {
        double t = i / 10.0;
        recording.transform("/tf", t, "odom", "base_link", t);
        if (i % 5 == 0) {
          recording.odometry("/odom", t, t);
        }
        if (i == 30) {
          recording.odometry("/late", t, 3);
        }
      }
      recording.raw("/odd", "msgpack", 10, new byte[]{1, 2, 3});
    }
  }

  @AfterEach
  void close() {
    bench.close();
  }

  private FakeRficContext open(Map<String, Object> settings, String... wanted) {
    FakeRficContext context = bench.open(file, settings);
    for (String port : wanted) {
      context.demand(port, true);
    }
    return context;
  }

  private static List<Double> places(FakeRficContext context, String port) {
    return context.published.get(port).stream().map(p -> ((Odometry) p.value()).pose().translation().x()).toList();
  }

  @Test
  void messagesComeInOrderAtTheirTimes() {
    FakeRficContext context = open(Map.of(), ODOM);
    PlayBench.awaitX(context, ODOM, 0);
    bench.pass(1.2, 1.2);
    PlayBench.awaitX(context, ODOM, 1);
    assertEquals(List.of(0.0, 0.5, 1.0), places(context, ODOM));
    Stamp stamp = context.published.get(ODOM).getLast().stamp().orElseThrow();
    assertEquals(new Stamp(time(1), ClockKind.SIMULATED), stamp);
    bench.timeline.speed(2);
    bench.pass(1, 3.2);
    PlayBench.awaitX(context, ODOM, 3);
    bench.timeline.pause();
    bench.pass(60, 3.2);
    assertEquals(7, places(context, ODOM).size());
    assertEquals("run.mcap, 10 s, 5 topics", ((LinkState.Connected) context.links.getLast()).peer());
    assertEquals(List.of(), List.copyOf(context.commands.keySet()));
  }

  @Test
  void atAnyTimeTheLastMessageBeforeItHolds() {
    FakeRficContext context = open(STANDING, ODOM, "late");
    bench.seek(7.3);
    PlayBench.awaitX(context, ODOM, 7);
    PlayBench.awaitX(context, "late", 3);
    assertEquals(List.of(time(7.3)),
        List.copyOf(context.moves).subList(context.moves.size() - 1, context.moves.size()));
    bench.seek(2);
    PlayBench.awaitX(context, ODOM, 2);
    PlayBench.await(() -> "of late: " + PlayBench.last(context, "late"), () -> context.published.get("late").isEmpty());
    double age = (System.nanoTime() - context.published.get(ODOM).getLast().receivedNanos()) * 1e-9;
    assertTrue(age >= 0 && age < 30, "age " + age);
    assertFalse(bench.state().playing());
  }

  @Test
  void whatIsWantedLaterComesAsItIsThen() {
    FakeRficContext context = open(STANDING);
    bench.seek(4.2);
    context.demand(ODOM, true);
    PlayBench.awaitX(context, ODOM, 4);
    bench.timeline.play();
    bench.pass(0.5, 4.7);
    PlayBench.awaitX(context, ODOM, 4.5);
    assertEquals(List.of(4.0, 4.5), places(context, ODOM));
    context.demand(ODOM, false);
    context.demand("late", true);
    PlayBench.awaitX(context, "late", 3);
  }

  @Test
  void transformsOfTheLastSecondsAreThereAndThoseThatHoldForGood() {
    FakeRficContext context = open(STANDING);
    bench.seek(8);
    PlayBench.await(() -> "transforms: " + context.transforms.size(), () -> context.transforms.stream()
        .anyMatch(t -> t.stamp().nanos() == time(8) && t.child().name().equals("base_link")));
    assertTrue(context.transforms.stream().anyMatch(t -> t.fixed() && t.child().name().equals("laser")));
    assertTrue(context.transforms.stream().anyMatch(t -> t.stamp().nanos() == time(5.1)));
    assertTrue(context.transforms.stream().filter(t -> !t.fixed()).noneMatch(t -> t.stamp().nanos() > time(8)));
  }

  @Test
  void messagesSayTheirTopicAndDefinitionToWhoRecordsThemAgain() {
    FakeRficContext context = open(STANDING, ODOM);
    bench.seek(4);
    PlayBench.awaitX(context, ODOM, 4);
    RawOrigin origin = context.published.get(ODOM).getLast().raw().orElseThrow().origin();
    assertEquals("/odom", origin.topic());
    assertEquals("nav_msgs/msg/Odometry ros2msg", origin.definition().get()
        .map(each -> each.name() + " " + each.encoding()).orElseThrow());
  }

  @Test
  void transformsAreAsOldAsTheyAreInTheRecording() {
    FakeRficContext context = open(STANDING);
    bench.seek(8);
    PlayBench.await(() -> "transforms: " + context.transforms.size(), () -> received(context, 8).isPresent());
    double apart = (received(context, 8).orElseThrow() - received(context, 5.1).orElseThrow()) * 1e-9;
    assertTrue(apart > 2.8 && apart < 30, "received " + apart + " s apart");
  }

  /** When the transforms of a time are said to have been received. */
  private Optional<Long> received(FakeRficContext context, double seconds) {
    return context.published.get("tf").stream()
        .filter(each -> ((TransformSet) each.value()).transforms().stream()
            .anyMatch(t -> !t.fixed() && t.stamp().nanos() == time(seconds)))
        .map(each -> each.receivedNanos()).findFirst();
  }

  @Test
  void stepsGoFromMessageToMessageOfATopic() {
    FakeRficContext context = open(STANDING, ODOM);
    bench.seek(4.2);
    LaneId lane = new LaneId(bench.timeline.tracks().getFirst().id(), "/odom");
    bench.timeline.step(true, Optional.of(lane));
    bench.at(4.5);
    PlayBench.awaitX(context, ODOM, 4.5);
    int moves = context.moves.size();
    bench.timeline.step(true, Optional.empty());
    bench.at(4.6);
    assertEquals(moves, context.moves.size(), "what goes on by a little is not moved");
    bench.timeline.step(false, Optional.of(lane));
    bench.at(4.5);
    bench.timeline.step(false, Optional.of(lane));
    bench.at(4);
    PlayBench.awaitX(context, ODOM, 4);
  }

  @Test
  void atTheEndItStandsOrBeginsAgain() {
    FakeRficContext context = open(Map.of(), ODOM);
    bench.timeline.seek(time(9.8));
    bench.at(9.8);
    bench.real.addAndGet(50_000_000L);
    for (int i = 0; i < 5; i++) {
      bench.real.addAndGet(80_000_000L);
    }
    PlayBench.await(() -> bench.state().toString(), () -> {
      bench.real.addAndGet(10_000_000L);
      return !bench.state().playing();
    });
    bench.at(10);
    PlayBench.awaitX(context, ODOM, 10);
    bench.timeline.range(Optional.of(new TimeRange(time(2), time(3))));
    bench.timeline.loop(true);
    bench.timeline.play();
    bench.at(2);
    PlayBench.awaitX(context, ODOM, 2);
    int moves = context.moves.size();
    PlayBench.await(() -> bench.state().toString(), () -> {
      bench.real.addAndGet(10_000_000L);
      return context.moves.size() > moves;
    });
    assertTrue(bench.state().playing() && bench.state().looping());
    assertEquals(time(2), context.moves.getLast());
    assertTrue(places(context, ODOM).stream().allMatch(x -> x <= 3 || x >= 9.5), "nothing beyond the range");
  }

  @Test
  void twoRecordingsAreMovedTogether() throws RecordingException {
    Path other = folder.resolve("other.mcap");
    try (SmallRecording recording = new SmallRecording(other)) {
      recording.odometry("/odom", 5, 100).odometry("/odom", 15, 200);
    }
    FakeRficContext first = open(STANDING, ODOM);
    FakeRficContext second = bench.open(other, STANDING);
    second.demand(ODOM, true);
    assertEquals(new TimeRange(time(0), time(15)), bench.state().span().orElseThrow());
    bench.seek(12);
    PlayBench.awaitX(first, ODOM, 10);
    PlayBench.awaitX(second, ODOM, 100);
    bench.seek(4);
    PlayBench.awaitX(first, ODOM, 4);
    PlayBench.await(() -> PlayBench.last(second, ODOM), () -> second.published.get(ODOM).isEmpty());
    assertEquals(List.of("/odom"), bench.timeline.tracks().stream().filter(t -> t.file().equals(other)).findFirst()
        .orElseThrow().lanes().stream().map(lane -> lane.topic()).toList());
  }

  @Test
  void anOffsetMovesARecordingAndItsRobotKeepsItsOwnTime() {
    FakeRficContext context = bench.open(file, Map.of("play", false, "offset", 100.0));
    context.demand(ODOM, true);
    assertEquals(new TimeRange(time(100), time(110)), bench.state().span().orElseThrow());
    bench.seek(106);
    PlayBench.awaitX(context, ODOM, 6);
    assertEquals(time(6), context.moves.getLast());
  }

  @Test
  void whatNobodyCanReadIsNamedAndTheRestIsPlayed() {
    FakeRficContext context = open(STANDING, "odd", ODOM);
    bench.seek(1);
    PlayBench.awaitX(context, ODOM, 1);
    PlayBench.await(() -> context.links.toString(), () -> context.links.getLast() instanceof LinkState.Degraded d
        && d.reason().contains("msgpack"));
  }

  @Test
  void whatARobotIsMadeOfStaysWhereItWasSaidOnce() throws RecordingException {
    Path described = folder.resolve("described.mcap");
    try (SmallRecording recording = new SmallRecording(described)) {
      recording.odometry("/odom", 0, 0).say("/robot_description", "std_msgs/msg/String",
          Map.of("offered_qos_profiles", "- durability: 1\n"), 1, Map.of("data", "<robot name=\"r\"/>"))
          .odometry("/odom", 5, 5);
    }
    FakeRficContext context = bench.open(described, STANDING);
    bench.seek(4);
    PlayBench.await(() -> context.published.toString(), () -> context.published.containsKey("robot_description")
        && context.published.get("robot_description").size() == 1);
    bench.seek(0);
    bench.seek(4);
    assertEquals(1, context.published.get("robot_description").size());
  }

  @Test
  void timesThatNobodyMeansHoldNothingUp() throws RecordingException {
    Path odd = folder.resolve("odd.mcap");
    try (SmallRecording recording = new SmallRecording(odd)) {
      recording.odometry("/odom", 0, 0).odometry("/odom", 1, 1);
      recording.at("/odom", Long.MAX_VALUE).at("/odom", Long.MIN_VALUE).at("/odom", Long.MAX_VALUE / 2);
    }
    FakeRficContext context = bench.open(odd, Map.of("play", false, "offset", 4e9));
    context.demand(ODOM, true);
    TimeRange span = bench.state().span().orElseThrow();
    assertTrue(span.start() >= 0 && span.length() > 0, span.toString());
    bench.seek(4e9 + 0.5);
    PlayBench.awaitX(context, ODOM, 0);
    bench.timeline.seek(Long.MAX_VALUE);
    PlayBench.awaitX(context, ODOM, 1);
  }

  @Test
  void howOftenTopicsSpeakIsKnownAfterAWhile() {
    open(STANDING);
    PlayBench.await(() -> bench.timeline.tracks().toString(), () -> bench.timeline.tracks().getFirst().lanes().stream()
        .allMatch(lane -> !lane.density().isEmpty()));
    bench.timeline.tracks().getFirst().lanes().forEach(lane -> assertEquals(lane.count(),
        lane.density().stream().mapToLong(Integer::longValue).sum(), lane.topic()));
  }
}
