package org.robotui.uic.plot.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.testkit.KeptHistory.BEGIN;
import static org.robotui.testkit.KeptHistory.SECOND;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.testkit.FakeClock;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeSettings;
import org.robotui.testkit.KeptHistory;
import org.robotui.testkit.KeptTimeline;
import org.robotui.uic.plot.internal.Robots;
import org.robotui.uic.plot.internal.trace.Samples;
import org.robotui.uic.plot.internal.trace.TimeSpan;

class WholeSeriesTest {
  private static final String ODOM = "/odom";
  private static final String X = "base./odom:linear.x";
  private static final SourceId OTHER = new SourceId("other", "/odom");

  private final FakeInput<Data> input = new FakeInput<>();
  private final FakeSettings settings = new FakeSettings(PlotOptions.schema());
  private final KeptTimeline timeline = new KeptTimeline();
  private final KeptHistory history = new KeptHistory(timeline);
  private final List<Runnable> waiting = new ArrayList<>();
  private PlotEngine engine;

  @BeforeEach
  void begin() {
    Robots.candidates(input);
    input.history(Robots.ODOM, history);
    settings.set(PlotOptions.GAP, 0.0);
    engine = engine(1_000_000);
  }

  private PlotEngine engine(long most) {
    return new PlotEngine(input, new FakeClock(), settings, new WholeSeries(input, waiting::add, most));
  }

  private void plot(String... signals) {
    settings.set(PlotOptions.AXES, List.of(Map.of("traces", List.of(signals))));
  }

  private PlotScene tick() {
    return engine.tick(System.nanoTime());
  }

  /** Runs what waits in the background, then ticks again. */
  private PlotScene read() {
    tick();
    waiting.forEach(Runnable::run);
    waiting.clear();
    return tick();
  }

  private static TraceView trace(PlotScene scene, int index) {
    return scene.axes().getFirst().get(index);
  }

  /** Seconds since the begin and values in turn. */
  private static List<Double> samples(PlotScene scene, int index) {
    Samples samples = trace(scene, index).series().orElseThrow().samples();
    List<Double> all = new ArrayList<>();
    for (int i = 0; i < samples.size(); i++) {
      all.add((samples.time(i) - BEGIN) / (double) SECOND);
      all.add(samples.value(i));
    }
    return all;
  }

  private void odometry(double... secondsAndValues) {
    for (int i = 0; i < secondsAndValues.length; i += 2) {
      history.add(ODOM, secondsAndValues[i], Robots.odometry(secondsAndValues[i + 1], 0));
    }
  }

  @Test
  void aTraceOfARecordingIsReadWholeAndNotAskedFor() {
    odometry(0, 1, 1, 2, 5, 3);
    plot(X);
    timeline.seek(BEGIN + SECOND);
    PlotScene before = tick();
    assertInstanceOf(InputState.Waiting.class, trace(before, 0).state());
    assertEquals(OptionalDouble.of(0), before.replay().orElseThrow().progress());
    PlotScene scene = read();
    assertEquals(List.of(0.0, 1.0, 1.0, 2.0, 5.0, 3.0), samples(scene, 0));
    assertInstanceOf(InputState.Live.class, trace(scene, 0).state());
    assertEquals("m/s", trace(scene, 0).unit());
    Replay replay = scene.replay().orElseThrow();
    assertEquals(new TimeSpan(BEGIN, BEGIN + 5 * SECOND), replay.span());
    assertEquals(BEGIN + SECOND, replay.position());
    assertEquals(OptionalDouble.empty(), replay.progress());
    assertEquals(Set.of(), input.chosen());
    tick();
    assertEquals(1, history.readings());
  }

  @Test
  void severalTracesAreReadTogetherAndOneMoreByItself() {
    odometry(0, 1, 1, 2);
    plot(X, "base./odom:linear.y", "derivative(base./odom:linear.x)");
    PlotScene scene = read();
    assertEquals(1, history.readings());
    assertEquals(List.of(0.5, 1.0), samples(scene, 2));
    plot(X, "base./odom:linear.y", "scale(base./odom:linear.x, 10)");
    scene = read();
    assertEquals(2, history.readings());
    assertEquals(List.of(0.0, 10.0, 1.0, 20.0), samples(scene, 2));
  }

  @Test
  void liveSourcesStayAsTheyAre() {
    odometry(0, 1, 1, 2);
    plot(X, "arm./joint_states:joints[0].position", "difference(base./odom:linear.x, base./sonar:readings[0].range)");
    PlotScene scene = read();
    assertEquals(Set.of(Robots.ODOM, Robots.JOINTS, Robots.SONAR), input.chosen());
    input.put(Robots.JOINTS, Robots.joints(1), System.nanoTime(), Optional.empty());
    scene = tick();
    assertEquals(4, samples(scene, 0).size());
    assertEquals(1, trace(scene, 1).series().orElseThrow().size());
    assertEquals(new TimeSpan(BEGIN, BEGIN + SECOND), scene.extent().orElseThrow());
  }

  @Test
  void aRecordingThatIsMovedIsPlacedAnew() {
    odometry(0, 1, 1, 2);
    plot(X);
    read();
    history.offset(100 * SECOND);
    PlotScene scene = read();
    assertEquals(List.of(100.0, 1.0, 101.0, 2.0), samples(scene, 0));
    assertEquals(BEGIN + 100 * SECOND, scene.replay().orElseThrow().span().from());
  }

  @Test
  void aRecordingThatIsOpenedAnewIsReadAnew() {
    odometry(0, 1);
    plot(X);
    read();
    KeptHistory next = new KeptHistory(timeline).add(ODOM, 7, Robots.odometry(8, 0));
    input.history(Robots.ODOM, next);
    assertEquals(List.of(7.0, 8.0), samples(read(), 0));
  }

  @Test
  void signalsOfTwoRecordingsMeetOnTheTimeline() {
    odometry(0, 1, 1, 2, 2, 3);
    KeptHistory other = new KeptHistory(timeline);
    other.offset(-10 * SECOND);
    other.add(ODOM, 10, Robots.odometry(100, 0)).add(ODOM, 12, Robots.odometry(300, 0));
    input.history(OTHER, other);
    plot("difference(other./odom:linear.x, base./odom:linear.x)", X);
    PlotScene scene = read();
    assertEquals(List.of(0.0, 99.0, 2.0, 297.0), samples(scene, 0));
    assertEquals(6, samples(scene, 1).size());
    assertEquals(1, history.readings());
  }

  @Test
  void stampsOfAnotherClockGoOnFromWhereTheyWereRecorded() {
    history.add(ODOM, BEGIN, OptionalLong.of(7 * SECOND), Robots.odometry(1, 0));
    history.add(ODOM, BEGIN + 2 * SECOND, OptionalLong.of(8 * SECOND), Robots.odometry(2, 0));
    history.add(ODOM, BEGIN + 3 * SECOND, OptionalLong.of(9 * SECOND), Robots.odometry(3, 0));
    history.add(ODOM, BEGIN + 60 * SECOND, OptionalLong.of(1), Robots.odometry(4, 0));
    history.add(ODOM, BEGIN + 61 * SECOND, OptionalLong.empty(), Robots.odometry(5, 0));
    plot(X);
    assertEquals(List.of(0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 60.0, 4.0, 61.0, 5.0), samples(read(), 0));
  }

  @Test
  void stampsALittleBackAreLeftOutAndCounted() {
    odometry(0, 1, 1, 2);
    history.add(ODOM, BEGIN + 2 * SECOND, OptionalLong.of(BEGIN), Robots.odometry(3, 0));
    odometry(3, 4);
    plot(X);
    PlotScene scene = read();
    assertEquals(List.of(0.0, 1.0, 1.0, 2.0, 3.0, 4.0), samples(scene, 0));
    assertEquals(1, trace(scene, 0).late());
  }

  @Test
  void whatWasReadBeforeAFailureStays() {
    odometry(0, 1, 1, 2);
    history.fail("the disk is gone");
    plot(X);
    PlotScene scene = read();
    assertEquals(4, samples(scene, 0).size());
    assertTrue(trace(scene, 0).problem().orElseThrow().contains("the disk is gone"));
    assertEquals(OptionalDouble.empty(), scene.replay().orElseThrow().progress());
  }

  @Test
  void readingEndsWithTheTrace() {
    for (int i = 0; i < 1000; i++) {
      odometry(i, i);
    }
    plot(X);
    tick();
    plot();
    tick();
    waiting.forEach(Runnable::run);
    assertEquals(0, history.given());
  }

  @Test
  void whatHasNoRoomIsThinnedToItsExtremes() {
    settings.set(PlotOptions.MEMORY, 1000L);
    engine = engine(1000);
    for (int i = 0; i < 10_000; i++) {
      odometry(i * 0.01, i == 7777 ? 500 : Math.sin(i));
    }
    plot(X);
    PlotScene scene = read();
    int kept = trace(scene, 0).series().orElseThrow().size();
    assertTrue(kept >= 900 && kept <= 1100, kept + " samples");
    assertTrue(samples(scene, 0).contains(500.0));
    assertTrue(trace(scene, 0).recorded().orElseThrow().contains("of each 20 samples"));
    assertEquals(0.0, samples(scene, 0).getFirst(), 0.2);
  }

  @Test
  void statisticsAreCopiedAsATableWithAllDigits() {
    odometry(0, 1.25, 1, 2.25, 2, 4);
    plot(X, "base./odom:speed");
    PlotScene scene = read();
    TimeSpan first = new TimeSpan(BEGIN, BEGIN + SECOND);
    assertEquals("""
        Trace\tSamples\tMinimum\tMaximum\tMean\tStd. deviation\tRate [Hz]
        linear.x [m/s]\t2\t1.25\t2.25\t1.75\t0.5\t1
        speed\t0\t\t\t\t\t""", StatisticsRow.table(StatisticsRow.of(scene, axis -> first)));
  }

  @Test
  void aFieldThatIsNotThereIsNamed() {
    odometry(0, 1);
    plot("base./odom:speed");
    PlotScene scene = read();
    assertTrue(trace(scene, 0).problem().orElseThrow().contains("has no field 'speed'"));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
  void whateverIsRecordedCanBePlotted(int seed) {
    Random random = new Random(seed);
    long time = random.nextInt(3) == 0 ? Long.MAX_VALUE / 2 - 2000L * SECOND : BEGIN;
    double[] odd = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 0, -0.0, Double.MAX_VALUE,
        Double.MIN_VALUE, -1e300};
    long[] stamps = {0, 1, -1, Long.MAX_VALUE, Long.MIN_VALUE, Long.MAX_VALUE - 1};
    for (int i = 0; i < 2000; i++) {
      double value = random.nextInt(5) == 0 ? odd[random.nextInt(odd.length)] : random.nextGaussian();
      long stamp = random.nextInt(20) == 0 ? stamps[random.nextInt(stamps.length)]
          : time + (long) (random.nextGaussian() * SECOND);
      history.add(ODOM, time, random.nextBoolean() ? OptionalLong.of(stamp) : OptionalLong.empty(),
          new MapRecord("Odd", Map.of("a", new FieldValue.Num(value, ""), "b", new FieldValue.Num(-value, ""))));
      time += random.nextInt(4) == 0 ? 0 : random.nextInt(1_000_000_000);
    }
    settings.set(PlotOptions.GAP, 1.0);
    plot("base./odom:a", "derivative(base./odom:a)", "average(base./odom:a, 3)", "integral(base./odom:a)",
        "norm(base./odom:a, base./odom:b)", "base./odom:b");
    PlotScene scene = read();
    for (TraceView each : scene.axes().getFirst()) {
      Samples samples = each.series().orElseThrow().samples();
      assertTrue(samples.size() > 500, each.label() + ": " + samples.size());
      for (int i = 1; i < samples.size(); i++) {
        assertTrue(samples.time(i) >= samples.time(i - 1), each.label() + " at " + i);
      }
      assertEquals(Optional.empty(), each.problem());
    }
  }
}
