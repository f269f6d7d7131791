package org.robotui.uic.topics.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.Input.Candidate;
import org.robotui.api.port.InputState;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.data.array.Bytes;
import org.robotui.data.sensor.Battery;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.ask.Measure;
import org.robotui.uic.topics.internal.TopicsOptions;
import org.robotui.uic.topics.internal.TopicsPorts;

class TopicsModelTest {
  private static final long MILLI = 1_000_000;
  private static final SourceId ODOM = new SourceId("base", "odom");

  private final FakeUicContext context = new FakeUicContext("topics", TopicsOptions.schema());
  private final FakeGraph graph = new FakeGraph();
  private final TopicsModel model = new TopicsModel(context);
  private long now = System.nanoTime();

  @Test
  void withoutARobotTheReasonIsSaid() {
    tick();
    assertInstanceOf(InputState.Unconnected.class, model.look().state());
  }

  @Test
  void whatIsNotSeenIsNotAsked() {
    connect(graph.add(Kind.TOPIC, "/odom", "nav_msgs/Odometry"));
    model.tick(now, options());
    assertEquals(0, graph.listed());
    assertInstanceOf(InputState.Waiting.class, model.look().state());
    tick();
    assertEquals(Catalog.KINDS.size(), graph.listed());
  }

  @Test
  void robotsAreAskedSlowlyAndAtOnceOnRequest() {
    connect(graph.add(Kind.TOPIC, "/odom", "nav_msgs/Odometry"));
    for (int i = 0; i < 10; i++) {
      tick();
    }
    assertEquals(Catalog.KINDS.size(), graph.listed(), "one second is less than the period");
    model.refresh();
    tick();
    assertEquals(2 * Catalog.KINDS.size(), graph.listed());
    now += 2500 * MILLI;
    tick();
    assertEquals(3 * Catalog.KINDS.size(), graph.listed());
  }

  @Test
  void aRobotThatFailsSaysWhyAndKeepsWhatItSaid() {
    connect(graph.add(Kind.TOPIC, "/odom", "nav_msgs/Odometry"));
    graph.fail(Optional.of("localhost:11311 refuses the connection"));
    ticks(2);
    assertEquals("base does not answer: localhost:11311 refuses the connection", model.look().state().explanation());
    graph.fail(Optional.empty());
    again();
    assertEquals(List.of("/odom"), names());
    graph.fail(Optional.of("timed out"));
    again();
    assertEquals(List.of("/odom"), names());
    assertEquals("base does not answer: timed out", model.look().notice());
  }

  @Test
  void wordsFilterAllKindsAndAreCounted() {
    connect(graph.add(Kind.TOPIC, "/odom", "nav_msgs/Odometry").add(Kind.TOPIC, "/scan", "sensor_msgs/LaserScan")
        .add(Kind.NODE, "/odometer", "").add(Kind.NODE, "/driver", ""));
    model.list(Kind.TOPIC, "ODOM");
    ticks(2);
    assertEquals(List.of("/odom"), names());
    assertEquals(1, model.look().counts().get(Kind.NODE));
    model.list(Kind.NODE, "ODOM");
    tick();
    assertEquals(List.of("/odometer"), names());
    model.list(Kind.TOPIC, "sensor scan");
    tick();
    assertEquals(List.of("/scan"), names());
  }

  @Test
  void nothingIsSubscribedBeforeTheUserAsksForIt() {
    odometry();
    assertEquals(Set.of(), context.input(TopicsPorts.ALL).chosen());
    model.select(Optional.of(topic("/odom")));
    ticks(2);
    assertEquals(Set.of(), context.input(TopicsPorts.ALL).chosen());
    model.echo(Optional.of(topic("/odom")));
    ticks(2);
    assertEquals(Set.of(ODOM), context.input(TopicsPorts.ALL).chosen());
    model.echo(Optional.empty());
    ticks(2);
    assertEquals(Set.of(), context.input(TopicsPorts.ALL).chosen());
  }

  @Test
  void onlySoManyAreMeasuredAtOnce() {
    List<Candidate> candidates = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      graph.add(Kind.TOPIC, "/t" + i, "std_msgs/Empty");
      candidates.add(new Candidate(new SourceId("base", "t" + i), "DynamicRecord"));
    }
    context.input(TopicsPorts.ALL).candidates(candidates);
    connect(graph);
    ticks(2);
    for (int i = 0; i < 5; i++) {
      model.measure(topic("/t" + i), true, 3);
    }
    ticks(2);
    assertEquals(3, context.input(TopicsPorts.ALL).chosen().size());
    assertTrue(model.look().notice().startsWith("3 topics are measured already"), model.look().notice());
    model.measure(topic("/t0"), false, 3);
    ticks(2);
    assertEquals(2, context.input(TopicsPorts.ALL).chosen().size());
    assertEquals("", model.look().notice());
  }

  @Test
  void aMeasuredTopicHasRateAndBandwidth() {
    odometry();
    model.measure(topic("/odom"), true, 10);
    ticks(2);
    for (int i = 0; i < 20; i++) {
      now += 50 * MILLI;
      put(100);
      model.tick(now, options());
    }
    ticks(6);
    Measure measure = model.look().rows().getFirst().measure().orElseThrow();
    assertEquals(20, measure.hertz(), 0.1);
    assertEquals(2000, measure.bytesPerSecond().orElseThrow(), 10);
    assertEquals(20, measure.count());
  }

  @Test
  void theEchoShowsTheNewestUntilItIsHeld() {
    odometry();
    model.echo(Optional.of(topic("/odom")));
    ticks(2);
    put(10);
    put(11);
    ticks(1);
    assertEquals(2, model.look().echo().shown().orElseThrow().number());
    model.pause(true);
    ticks(1);
    put(12);
    ticks(1);
    assertEquals(2, model.look().echo().shown().orElseThrow().number());
    assertEquals(1, model.look().echo().missed());
    model.pin(1);
    ticks(1);
    assertEquals(1, model.look().echo().shown().orElseThrow().number());
    model.pause(false);
    put(13);
    ticks(1);
    assertEquals(4, model.look().echo().shown().orElseThrow().number());
  }

  @Test
  void theHistoryIsBounded() {
    odometry();
    model.echo(Optional.of(topic("/odom")));
    ticks(2);
    for (int i = 0; i < 250; i++) {
      put(8);
    }
    ticks(1);
    assertEquals(100, model.look().echo().history().size());
    assertEquals(250, model.look().echo().count());
  }

  @Test
  void whyThereIsNoEchoIsSaid() {
    connect(graph.add(Kind.TOPIC, "/tf", "tf2_msgs/TFMessage").add(Kind.TOPIC, "/cmd_vel", "geometry_msgs/Twist")
        .describe(Kind.TOPIC, "/cmd_vel", "geometry_msgs/Twist", Map.of("publishers", "none", "subscribers", "/base"),
            "", Optional.empty()));
    ticks(2);
    model.select(Optional.of(topic("/tf")));
    ticks(2);
    assertTrue(model.look().echo().obstacle().contains("as frames"), model.look().echo().obstacle());
    model.select(Optional.of(topic("/cmd_vel")));
    ticks(2);
    assertEquals("Nobody publishes it.", model.look().echo().obstacle());
  }

  @Test
  void factsThatNameThingsLeadToThem() {
    connect(graph.add(Kind.TOPIC, "/odom", "nav_msgs/Odometry").add(Kind.NODE, "/base", "").add(Kind.NODE, "/map", "")
        .describe(Kind.TOPIC, "/odom", "nav_msgs/Odometry",
            Map.of("subscribers", "/base, /map, /gone"), "Header header", Optional.empty()));
    ticks(2);
    model.select(Optional.of(topic("/odom")));
    ticks(2);
    List<Fact> facts = model.look().described().orElseThrow().facts();
    assertEquals(List.of("/base", "/map", "/gone"), facts.stream().map(Fact::value).toList());
    assertEquals(Optional.of(new Key("base", Kind.NODE, "/map")), facts.get(1).target());
    assertEquals(Optional.empty(), facts.get(2).target());
    assertEquals(3, model.look().rows().getFirst().counts().subscribers().orElseThrow());
  }

  @Test
  void twoThousandTopicsAreLookedAtOnlyWhenSomethingChanged() {
    connect(FakeGraph.large());
    ticks(3);
    assertEquals(2000, model.look().rows().size());
    assertEquals(200, model.look().counts().get(Kind.NODE));
    List<TopicRow> rows = model.look().rows();
    long looked = model.looked();
    for (int i = 0; i < 400; i++) {
      now += 20 * MILLI;
      model.seen(now);
      model.tick(now, options());
    }
    assertSame(rows, model.look().rows(), "listing the same again changes nothing");
    assertEquals(looked, model.looked(), "and looks at nothing");
    model.list(Kind.TOPIC, "robot19 topic07");
    ticks(1);
    assertEquals(10, model.look().rows().size());
    assertTrue(model.looked() - looked <= 2 * 2200 + 2000, "one look for the counts, one for the rows");
  }

  @Test
  void measuringOneOfTwoThousandLooksAtMostTwiceASecond() {
    context.input(TopicsPorts.ALL)
        .candidates(List.of(new Candidate(new SourceId("base", "robot000/part/topic00"), "DynamicRecord")));
    connect(FakeGraph.large());
    ticks(3);
    model.measure(topic("/robot000/part/topic00"), true, 10);
    ticks(3);
    long looked = model.looked();
    for (int i = 0; i < 500; i++) {
      now += 20 * MILLI;
      model.seen(now);
      context.input(TopicsPorts.ALL).put(new SourceId("base", "robot000/part/topic00"), battery(), now,
          Optional.empty());
      model.tick(now, options());
    }
    assertTrue(model.looked() - looked <= 21 * 2000, "looked at " + (model.looked() - looked));
  }

  @Test
  void aTickWithoutNewsAsksForNoPaint() {
    connect(graph.add(Kind.TOPIC, "/odom", "nav_msgs/Odometry"));
    ticks(3);
    int paints = 0;
    for (int i = 0; i < 250; i++) {
      now += 20 * MILLI;
      model.seen(now);
      paints += model.tick(now, options()) ? 1 : 0;
    }
    assertTrue(paints <= 5, "five seconds have five beats, had " + paints);
    assertFalse(model.tick(now, options()));
  }

  @Test
  void whatIsClosedAsksForNothing() {
    odometry();
    model.echo(Optional.of(topic("/odom")));
    ticks(2);
    model.close();
    assertEquals(Set.of(), context.input(TopicsPorts.ALL).chosen());
  }

  private void odometry() {
    context.input(TopicsPorts.ALL).candidates(List.of(new Candidate(ODOM, "Odometry")));
    connect(graph.add(Kind.TOPIC, "/odom", "nav_msgs/Odometry"));
    ticks(2);
  }

  private void put(int size) {
    RawMessage raw = new RawMessage("nav_msgs/Odometry", "ros1", Bytes.of(new byte[size]), RawMessage.Reader.NONE);
    context.input(TopicsPorts.ALL).put(ODOM, battery(), now, Optional.empty(), Optional.of(raw));
  }

  private static Battery battery() {
    return new Battery(14.1, -1.2, 0.5, Battery.Status.DISCHARGING);
  }

  private void connect(FakeGraph robot) {
    context.robots(List.of(robot.robot("base")));
  }

  private void again() {
    model.refresh();
    ticks(2);
  }

  private void ticks(int count) {
    for (int i = 0; i < count; i++) {
      tick();
    }
  }

  private void tick() {
    now += 100 * MILLI;
    model.seen(now);
    model.tick(now, options());
  }

  private TopicsOptions options() {
    return TopicsOptions.of(context.settings().current());
  }

  private List<String> names() {
    return model.look().rows().stream().map(row -> row.key().name()).toList();
  }

  private static Key topic(String name) {
    return new Key("base", Kind.TOPIC, name);
  }
}
