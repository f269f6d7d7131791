package org.robotui.uic.plot.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.api.time.RobotClock;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeSettings;
import org.robotui.uic.plot.internal.Robots;
import org.robotui.uic.plot.internal.trace.Samples;
import org.robotui.uic.plot.internal.trace.Series;
import org.robotui.uic.plot.internal.trace.TimeSpan;

class PlotEngineTest {
  private static final long SECOND = 1_000_000_000L;
  private static final String X = "base./odom:linear.x";

  private final FakeInput<Data> input = new FakeInput<>();
  private final FakeSettings settings = new FakeSettings(PlotOptions.schema());
  private final Clock clock = new Clock();
  private PlotEngine engine;

  @BeforeEach
  void begin() {
    Robots.candidates(input);
    engine = new PlotEngine(input, clock, settings, new WholeSeries(input, Runnable::run));
  }

  @Test
  void onlyWhatIsPlottedOrLookedAtIsAskedOfTheRobot() {
    tick();
    assertEquals(Set.of(), input.chosen());
    plot(X, "difference(base./odom:linear.y, arm./joint_states:joints[0].position)");
    tick();
    assertEquals(Set.of(Robots.ODOM, Robots.JOINTS), input.chosen());
    plot(X);
    engine.watch(Set.of(Robots.SONAR));
    tick();
    assertEquals(Set.of(Robots.ODOM, Robots.SONAR), input.chosen());
  }

  @Test
  void everyValueIsRecordedAtTheTimeOfItsStamp() {
    plot(X);
    tick();
    drive(1, 10);
    drive(2, 20);
    tick();
    assertSamples(series(0), 1, 10, 2, 20);
    assertEquals("m/s", trace(0).unit());
    assertInstanceOf(InputState.Live.class, trace(0).state());
  }

  @Test
  void theTimeOfReceiptCountsWhereItIsWanted() {
    settings.set(PlotOptions.TIME, PlotOptions.BY_RECEIPT);
    plot(X);
    tick();
    input.put(Robots.ODOM, Robots.odometry(1, 0), 5 * SECOND, stamp(1000));
    input.put(Robots.ODOM, Robots.odometry(2, 0), 7 * SECOND, stamp(1));
    tick();
    Samples samples = series(0).samples();
    assertEquals(2 * SECOND, samples.time(1) - samples.time(0));
  }

  @Test
  void aClockThatIsSetBackBeginsTheTraceAnew() {
    plot(X);
    tick();
    drive(100, 1);
    drive(101, 2);
    drive(5, 3);
    tick();
    assertSamples(series(0), 5, 3);
  }

  @Test
  void aSignalOverAnotherOneMeetsItAtItsOwnTimes() throws IOException {
    settings.set(PlotOptions.AXES,
        List.of(Map.of("x", "arm./joint_states:joints[0].position", "traces", List.of(X))));
    tick();
    assertEquals(Set.of(Robots.ODOM, Robots.JOINTS), input.chosen());
    input.put(Robots.JOINTS, Robots.joints(0), 0, stamp(1));
    drive(1, 10);
    drive(1.5, 20);
    input.put(Robots.JOINTS, Robots.joints(0.2), 0, stamp(2));
    drive(2, 30);
    tick();
    assertSamples(series(0), 1, 10, 1.5, 20, 2, 30);
    assertSamples(trace(0).over().orElseThrow().curve().x(), 1, 0, 1.5, Math.sin(0.2) / 2, 2, Math.sin(0.2));
    assertEquals("joints[0].position", trace(0).over().orElseThrow().label());
    StringWriter csv = new StringWriter();
    new CsvExport(CsvExport.Column.of(trace(0)).toList(), new TimeSpan(0, 9 * SECOND)).write(csv);
    assertEquals("time [s],arm./joint_states:joints[0].position,base./odom:linear.x [m/s]\n1.000000000,0,10\n",
        csv.toString().lines().limit(2).map(line -> line + "\n").collect(Collectors.joining()));
  }

  @Test
  void whatIsWrongWithTheSignalAcrossIsSaidOfEachTrace() {
    settings.set(PlotOptions.AXES, List.of(Map.of("x", "sine(a.b:c)", "traces", List.of(X))));
    tick();
    assertTrue(trace(0).problem().orElseThrow().startsWith("x: there is no function 'sine'"),
        trace(0).problem().toString());
  }

  @Test
  void aViewThatIsStartedAgainGoesOnWithItsHistory() {
    plot(X);
    tick();
    drive(1, 10);
    drive(2, 20);
    tick();
    engine = new PlotEngine(input, clock, settings, new WholeSeries(input, Runnable::run), engine);
    drive(3, 30);
    tick();
    assertSamples(series(0), 1, 10, 2, 20, 3, 30);
    assertEquals(Set.of(Robots.ODOM), input.chosen());
  }

  @Test
  void whatIsNotPlottedAnyMoreIsNotTakenOver() {
    plot(X);
    tick();
    drive(1, 10);
    tick();
    plot("base./odom:linear.y");
    engine = new PlotEngine(input, clock, settings, new WholeSeries(input, Runnable::run), engine);
    tick();
    plot(X);
    tick();
    assertSamples(series(0));
  }

  @Test
  void aNewEpochForgetsAll() {
    plot(X);
    tick();
    drive(100, 1);
    tick();
    clock.epoch = 1;
    drive(100.1, 2);
    tick();
    assertSamples(series(0), 100.1, 2);
  }

  @Test
  void aStampALittleBackIsLeftOutAndCounted() {
    plot(X);
    tick();
    drive(10, 1);
    drive(9.9, 2);
    drive(10.1, 3);
    tick();
    assertSamples(series(0), 10, 1, 10.1, 3);
    assertEquals(1, trace(0).late());
  }

  @Test
  void aSilentSourceBreaksTheLineButASlowOneDoesNot() {
    plot(X);
    tick();
    for (int i = 0; i < 10; i++) {
      drive(i * 0.1, i);
    }
    drive(5, 5);
    tick();
    Samples samples = series(0).samples();
    assertTrue(Double.isNaN(samples.value(10)));
    assertEquals(5, samples.value(11));
    plot("arm./joint_states:joints[0].position");
    tick();
    for (int i = 0; i < 10; i++) {
      input.put(Robots.JOINTS, Robots.joints(1), 0, stamp(i * 3));
    }
    tick();
    assertEquals(10, series(0).size());
  }

  @Test
  void whatIsWrongIsSaidAtTheTrace() {
    plot("base./odom:linear.q", "base./nothing:x", "sine(x)", "base./odom:frame");
    tick();
    drive(1, 1);
    tick();
    assertTrue(trace(0).problem().orElseThrow().contains("no field 'linear.q'; fields there are: x, y, z"),
        trace(0).problem().orElseThrow());
    assertTrue(trace(1).state().explanation().startsWith("base offers no '/nothing'; it offers /odom"),
        trace(1).state().explanation());
    assertTrue(trace(2).problem().orElseThrow().contains("no signal"), trace(2).problem().orElseThrow());
    assertTrue(trace(3).problem().isPresent());
  }

  @Test
  void aSourceThatIsAskedForIsWaitedFor() {
    plot("base./scan:ranges[3]");
    tick();
    assertInstanceOf(InputState.Waiting.class, trace(0).state());
  }

  @Test
  void whatIsDerivedAnewBeginsWithWhatWasRecorded() {
    plot(X);
    tick();
    for (int i = 0; i < 5; i++) {
      drive(i, i * i);
    }
    tick();
    plot("derivative(" + X + ")");
    tick();
    assertSamples(series(0), 0.5, 1, 1.5, 3, 2.5, 5, 3.5, 7);
    drive(5, 25);
    tick();
    assertEquals(9, series(0).newest().orElseThrow().value());
  }

  @Test
  void theSameFieldOfSeveralSourcesIsToldApart() {
    plot(X, "sim./odom:linear.x", "base./odom:linear.y");
    tick();
    assertEquals(List.of("base./odom:linear.x", "sim./odom:linear.x", "linear.y"),
        engine.begin(0).traces().map(TraceView::label).toList());
  }

  @Test
  void aTraceKeepsItsSamplesWhenItMoves() {
    plot(X);
    tick();
    drive(1, 1);
    tick();
    settings.set(PlotOptions.AXES,
        List.of(Map.of("traces", List.of("base./odom:angular.z")), Map.of("traces", List.of(X))));
    tick();
    assertEquals(1, engine.begin(0).axes().get(1).getFirst().series().orElseThrow().size());
  }

  @Test
  void samplesAreForgottenWhenMemoryIsSetAnew() {
    plot(X);
    tick();
    drive(1, 1);
    tick();
    settings.set(PlotOptions.MEMORY, 5_000L);
    tick();
    assertEquals(0, series(0).size());
  }

  @Test
  void theNewestValueOfAWatchedSourceIsThereToLearnItsFields() {
    engine.watch(Set.of(Robots.ODOM));
    tick();
    assertEquals(Optional.empty(), engine.newest(Robots.ODOM));
    drive(1, 1);
    tick();
    assertEquals(Robots.odometry(1, 0), engine.newest(Robots.ODOM).orElseThrow().value());
  }

  @Test
  void nowFollowsTheStampsEvenOfAClockThatIsFarOff() {
    plot(X);
    clock.now = 5_000 * SECOND;
    tick();
    drive(100, 1);
    assertEquals(100 * SECOND, tick().now());
    clock.now += SECOND / 2;
    assertEquals(100 * SECOND + SECOND / 2, tick().now());
  }

  private void plot(String... signals) {
    settings.set(PlotOptions.AXES, List.of(Map.of("traces", List.of(signals))));
  }

  private void drive(double seconds, double speed) {
    input.put(Robots.ODOM, Robots.odometry(speed, 0), 0, stamp(seconds));
  }

  private static Optional<Stamp> stamp(double seconds) {
    return Optional.of(new Stamp(Math.round(seconds * SECOND), ClockKind.ROBOT));
  }

  private PlotScene tick() {
    return engine.tick(0);
  }

  private TraceView trace(int index) {
    return engine.begin(0).axes().getFirst().get(index);
  }

  private Series series(int index) {
    return trace(index).series().orElseThrow();
  }

  private static void assertSamples(Series series, double... secondsAndValues) {
    Samples samples = series.samples();
    assertEquals(secondsAndValues.length / 2, samples.size());
    for (int i = 0; i < samples.size(); i++) {
      assertEquals(Math.round(secondsAndValues[2 * i] * SECOND), samples.time(i));
      assertEquals(secondsAndValues[2 * i + 1], samples.value(i), 1e-9);
    }
  }

  private static final class Clock implements RobotClock {
    private long epoch;
    private long now = 100 * SECOND;

    @Override
    public Stamp now() {
      return new Stamp(now, ClockKind.ROBOT);
    }

    @Override
    public ClockKind kind() {
      return ClockKind.ROBOT;
    }

    @Override
    public Optional<Duration> offset() {
      return Optional.empty();
    }

    @Override
    public long epoch() {
      return epoch;
    }
  }
}
