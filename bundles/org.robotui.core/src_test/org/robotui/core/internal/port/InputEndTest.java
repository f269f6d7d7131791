package org.robotui.core.internal.port;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Demand;
import org.robotui.api.port.InputState;
import org.robotui.api.port.Intake;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.support.ManualClock;
import org.robotui.core.internal.support.Samples;
import org.robotui.core.internal.time.Ageing;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.core.internal.time.RobotTime;
import org.robotui.core.internal.time.RuicClock;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;

class InputEndTest {
  private final ManualClock clock = new ManualClock();
  private final Link link = new Link(clock, () -> {});
  private final List<Boolean> demand = new ArrayList<>();
  private final StreamSource<LaserScan> front = source("front", LaserScan.class);
  private final StreamSource<LaserScan> rear = source("rear", LaserScan.class);
  private final InputEnd<LaserScan> input = new InputEnd<>(Intake.MATCHED, clock);

  private <T extends Data> StreamSource<T> source(String name, Class<T> type) {
    Demand told = demand::add;
    StreamPort<T> port = new StreamPort<>(name, type, Arity.ONE, "");
    return new StreamSource<>(new SourceId("base", name), port, link, clock, Ageing.by(clock), told, Runnable::run,
        o -> {});
  }

  private <T extends Data> void publish(StreamSource<T> source, T value) {
    source.publish(value, Optional.empty(), clock.nanos(), Optional.empty());
  }

  private void connected() {
    link.report(new LinkState.Connected("robot"));
  }

  private static String explanation(Class<? extends InputState> type, InputState state) {
    return assertInstanceOf(type, state).explanation();
  }

  @Test
  void withoutSourceItSaysWhatMatchingSays() {
    input.connect(List.of(), "map needs GridMap");
    assertEquals(new InputState.Unconnected("map needs GridMap"), input.state());
    assertTrue(input.latest().isEmpty());
    assertEquals(0, input.drain(e -> {}));
  }

  @Test
  void waitsLivesAndGoesStale() {
    input.connect(List.of(front), "");
    assertTrue(explanation(InputState.Waiting.class, input.state()).contains("no link yet (disconnected)"));
    connected();
    assertTrue(explanation(InputState.Waiting.class, input.state()).contains("no data yet"));
    for (int i = 0; i < 10; i++) {
      publish(front, Samples.scan(i));
      clock.advanceMillis(100);
    }
    assertEquals(10, assertInstanceOf(InputState.Live.class, input.state()).rateHz(), 1);
    clock.advanceMillis(850);
    assertInstanceOf(InputState.Live.class, input.state(), "within a second nothing is stale");
    clock.advanceMillis(100);
    assertTrue(explanation(InputState.Stale.class, input.state()).contains("usually every 0.10 s"));
  }

  @Test
  void aValueThatComesWhileItIsLookedAtIsNotFromAfterThatMoment() {
    connected();
    // A clock that takes its time, as when classes are loaded: meanwhile a value comes.
    NanoClock slow = () -> {
      long now = clock.nanos();
      clock.advanceMillis(300);
      publish(front, Samples.scan(1));
      return now;
    };
    InputEnd<LaserScan> end = new InputEnd<>(Intake.MATCHED, slow);
    end.connect(List.of(front), "");
    publish(front, Samples.scan(0));
    for (int i = 0; i < 3; i++) {
      assertEquals(0, front.status(slow).ageSeconds(), 1e-9);
      assertEquals(0, assertInstanceOf(InputState.Live.class, end.state()).ageSeconds(), 1e-9);
    }
  }

  @Test
  void slowSourcesAreStaleAfterThreePeriods() {
    connected();
    input.connect(List.of(front), "");
    for (int i = 0; i < 5; i++) {
      publish(front, Samples.scan(i));
      clock.advanceMillis(2000);
    }
    clock.advanceMillis(3900);
    assertInstanceOf(InputState.Live.class, input.state());
    clock.advanceMillis(200);
    assertInstanceOf(InputState.Stale.class, input.state());
  }

  @Test
  void mapsDoNotExpireButALostLinkIsTold() {
    connected();
    StreamSource<GridMap> source = source("map", GridMap.class);
    InputEnd<GridMap> end = new InputEnd<>(Intake.MATCHED, clock);
    end.connect(List.of(source), "");
    publish(source, new GridMap(new FrameId("r", "map"), 1, 1, 1, RigidTransform.IDENTITY, Bytes.of((byte) 0)));
    clock.advanceMillis(3_600_000);
    assertInstanceOf(InputState.Live.class, end.state());
    link.report(new LinkState.Failed("robot: no route", Duration.ofSeconds(2)));
    assertTrue(explanation(InputState.Stale.class, end.state()).contains("no route"));
  }

  @Test
  void anEstimateOfThePoseHoldsWhileTheRobotStands() {
    connected();
    StreamSource<PoseEstimate> source = source("localize:0", PoseEstimate.class);
    for (int i = 0; i < 20; i++) {
      publish(source, new PoseEstimate(new FrameId("r", "map"), RigidTransform.planar(i, 0, 0), Doubles.EMPTY)); // it
                                                                                                                 // drives
      clock.advanceMillis(200);
    }
    clock.advanceMillis(3_600_000);
    assertFalse(source.status(clock).stale(), source.status(clock).problem());
  }

  private record Event(String schema) implements DynamicRecord {
    @Override
    public List<String> fields() {
      return List.of();
    }

    @Override
    public Optional<FieldValue> field(String name) {
      return Optional.empty();
    }
  }

  @Test
  void aRecordOfWhichOnlyOneCameIsNoFault() {
    connected();
    StreamSource<DynamicRecord> source = source("events", DynamicRecord.class);
    publish(source, new Event("pressed"));
    clock.advanceMillis(3_600_000);
    assertFalse(source.status(clock).stale(), source.status(clock).problem());
    for (int i = 0; i < 20; i++) {
      publish(source, new Event("pressed"));
      clock.advanceMillis(100);
    }
    clock.advanceMillis(2000);
    assertTrue(source.status(clock).stale(), "what comes regularly and ends is one");
  }

  @Test
  void whatIsKeptForLateComersHoldsUnlessItComesOften() {
    connected();
    input.connect(List.of(front), "");
    front.kept(true);
    front.delivery("best effort");
    publish(front, Samples.scan(0));
    assertEquals("best effort", front.status(clock).delivery());
    clock.advanceMillis(3_600_000);
    assertInstanceOf(InputState.Live.class, input.state());
    for (int i = 0; i < 20; i++) {
      publish(front, Samples.scan(i));
      clock.advanceMillis(100);
    }
    clock.advanceMillis(2000);
    assertInstanceOf(InputState.Stale.class, input.state(), "a scanner that latches and stands still");
  }

  @Test
  void failureOfTheSourceIsToldUntilTheNextValue() {
    connected();
    input.connect(List.of(front), "");
    front.failed("robot sends std_msgs/String");
    assertTrue(explanation(InputState.Failed.class, input.state()).contains("std_msgs/String"));
    publish(front, Samples.scan(1));
    assertInstanceOf(InputState.Live.class, input.state());
  }

  @Test
  void whatWasReceivedStaysWhenItsSourceFailsAndItIsSaidSinceWhen() {
    connected();
    input.connect(List.of(front), "");
    publish(front, Samples.scan(1));
    clock.advanceMillis(5_000);
    front.failed("nobody publishes /front any more");
    clock.advanceMillis(12_000);
    front.failed("nobody publishes /front any more"); // as it is told again with each look at the graph
    InputState.Stale lost = assertInstanceOf(InputState.Stale.class, input.state());
    assertEquals(17, lost.ageSeconds(), 1e-6);
    assertEquals(12, lost.lostSeconds().orElseThrow(), 1e-6);
    assertEquals("base.front: nobody publishes /front any more", lost.explanation());
    assertTrue(input.latest().isPresent());
    assertTrue(front.status(clock).stale());
    assertEquals("nobody publishes /front any more", front.status(clock).problem());
    front.failed("");
    assertTrue(assertInstanceOf(InputState.Stale.class, input.state()).lostSeconds().isEmpty(),
        "late, but it may come");
    link.report(new LinkState.Failed("robot: no route", Duration.ofSeconds(2)));
    clock.advanceMillis(3_000);
    assertEquals(3, assertInstanceOf(InputState.Stale.class, input.state()).lostSeconds().orElseThrow(), 1e-6);
  }

  @Test
  void whatHoldsIsGivenAgainWhereAViewHasForgottenIt() {
    connected();
    StreamSource<GridMap> source = source("map", GridMap.class);
    InputEnd<GridMap> end = new InputEnd<>(Intake.MATCHED, clock);
    end.connect(List.of(source), "");
    publish(source, new GridMap(new FrameId("r", "map"), 1, 1, 1, RigidTransform.IDENTITY, Bytes.of((byte) 0)));
    assertEquals(1, end.drain(e -> {}));
    end.recall();
    assertEquals(1, end.drain(e -> assertEquals(source.id(), e.source())));
    assertEquals(0, end.drain(e -> {}));
    assertEquals(List.of(true), demand, "the robot is not asked to stop in between");
    input.connect(List.of(front, rear), "");
    publish(front, Samples.scan(1));
    rear.kept(true);
    publish(rear, Samples.scan(2));
    input.drain(e -> {});
    input.recall();
    List<SourceId> again = new ArrayList<>();
    input.drain(e -> again.add(e.source()));
    assertEquals(List.of(rear.id()), again, "a measurement of another time is not");
  }

  @Test
  void lostMessagesAreToldWhileNothingUsableCame() {
    connected();
    input.connect(List.of(front), "");
    front.lost(3, "robot: truncated scan");
    assertTrue(input.state().explanation().contains("truncated scan"));
    assertEquals(3, front.status(clock).dropped());
    assertEquals("robot: truncated scan", front.status(clock).problem());
  }

  @Test
  void aMessageThatCannotBeUsedMarksTheLastGoodValueUntilTheNext() {
    connected();
    input.connect(List.of(front), "");
    publish(front, Samples.scan(1));
    front.lost(1, "/scan from /laser: rangeMax: must not be below rangeMin");
    assertTrue(explanation(InputState.Stale.class, input.state()).contains("/scan from /laser: rangeMax"));
    assertTrue(((InputState.Stale) input.state()).refused());
    assertTrue(input.latest().isPresent(), "the last good value stays");
    clock.advanceMillis(3000);
    assertTrue(explanation(InputState.Stale.class, input.state()).contains("rangeMax"),
        "the reason counts, not the age");
    assertFalse(front.status(clock).stale(), "it is its problem that is told");
    publish(front, Samples.scan(2));
    assertInstanceOf(InputState.Live.class, input.state());
    assertTrue(front.status(clock).problem().contains("rangeMax"), "seldom losses are told as well");
    clock.advanceMillis(6000);
    publish(front, Samples.scan(3));
    assertEquals("", front.status(clock).problem());
    assertEquals(1, front.status(clock).dropped());
  }

  @Test
  void bestOfSeveralSourcesCounts() {
    connected();
    input.connect(List.of(front, rear), "");
    front.failed("broken");
    assertInstanceOf(InputState.Waiting.class, input.state());
    publish(rear, Samples.scan(2));
    assertInstanceOf(InputState.Live.class, input.state());
    assertInstanceOf(InputState.Failed.class, input.state(front.id()));
    assertInstanceOf(InputState.Unconnected.class, input.state(new SourceId("base", "none")));
    assertEquals(List.of(front.id(), rear.id()), input.sources());
  }

  @Test
  void latestIsTheNewestOfAllSourcesAndDrainKeepsTheOrderOfArrival() {
    input.connect(List.of(front, rear), "");
    publish(rear, Samples.scan(1));
    clock.advanceMillis(1);
    publish(front, Samples.scan(2));
    assertEquals(front.id(), input.latest().orElseThrow().source());
    assertEquals(rear.id(), input.latest(rear.id()).orElseThrow().source());
    List<SourceId> order = new ArrayList<>();
    assertEquals(2, input.drain(e -> order.add(e.source())));
    assertEquals(List.of(rear.id(), front.id()), order);
  }

  @Test
  void matchingAgainKeepsWhatAConnectionHolds() {
    input.connect(List.of(front), "");
    publish(front, Samples.scan(1));
    input.connect(List.of(front, rear), "");
    assertEquals(1, input.drain(e -> {}));
  }

  @Test
  void demandIsToldForTheFirstAndTheLastConsumer() {
    InputEnd<LaserScan> second = new InputEnd<>(Intake.MATCHED, clock);
    input.connect(List.of(front), "");
    second.connect(List.of(front), "");
    assertTrue(front.status(clock).wanted());
    input.connect(List.of(), "");
    second.connect(List.of(), "");
    assertEquals(List.of(true, false), demand);
    assertFalse(front.status(clock).wanted());
  }

  @Test
  void tapSeesWhatViewsSeeWithoutTheProducerKnowing() {
    input.connect(List.of(front), "");
    Tap<LaserScan> tap = front.join(Intake.MATCHED, () -> {});
    publish(front, Samples.scan(1));
    assertEquals(1, tap.drain(e -> {}));
    assertEquals(1, input.drain(e -> {}));
    front.leave(tap);
    assertEquals(List.of(true), demand);
  }

  @Test
  void closedSourcePublishesNothing() {
    input.connect(List.of(front), "");
    front.close();
    publish(front, Samples.scan(1));
    assertEquals(0, input.drain(e -> {}));
  }

  @Test
  void valuesOfARecordingGrowOldByItsTimeAndAreForgottenWhereItIsMoved() {
    RuicClock times = new RuicClock(clock, clock::nanos, () -> {});
    RobotTime time = times.source("recording");
    time.replayed(100_000_000_000L);
    StreamSource<LaserScan> played = new StreamSource<>(new SourceId("base", "scan"),
        new StreamPort<>("scan", LaserScan.class, Arity.ONE, ""), link, clock, time, wanted -> {}, Runnable::run,
        o -> {});
    connected();
    input.connect(List.of(played), "");
    for (int i = 0; i < 5; i++) {
      clock.advanceMillis(10_000); // a hundred times slower than it was recorded
      time.replayed(100_000_000_000L + i * 100_000_000L);
      publish(played, Samples.scan(i));
    }
    clock.advanceMillis(600_000);
    assertEquals(10, assertInstanceOf(InputState.Live.class, input.state()).rateHz(), 2);
    time.replayed(103_000_000_000L);
    assertTrue(explanation(InputState.Stale.class, input.state()).contains("no new value for 2.6 s"));
    played.forget();
    assertTrue(input.latest().isEmpty());
    assertInstanceOf(InputState.Waiting.class, input.state());
    publish(played, Samples.scan(7));
    assertInstanceOf(InputState.Live.class, input.state());
  }
}
