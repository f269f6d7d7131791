package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.RficContext;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.frame.FrameSink;
import org.robotui.api.host.Exchange;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.host.ExchangePreview.Line;
import org.robotui.api.host.ExchangePreview.Verdict;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.Ruic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.core.internal.support.Samples;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;

class ExchangeTest {
  private static final String YAML = """
      ruics:
        pioneer:
          rfics:
            base:
              type: fake
              peer: first
          uics:
            map:
              type: map
            teleop:
              type: teleop
      """;
  private static final StreamPort<LaserScan> LASER =
      new StreamPort<>("laser:0", LaserScan.class, Samples.SCAN.arity(), "");

  @TempDir
  Path folder;

  private CoreBench bench;
  private final List<String> order = new CopyOnWriteArrayList<>();
  private final List<Publication<LaserScan>> oldScans = new CopyOnWriteArrayList<>();
  private final List<Publication<LaserScan>> newScans = new CopyOnWriteArrayList<>();
  private final List<VelocityCommand> sent = new CopyOnWriteArrayList<>();
  private final FakeRobot robot = new FakeRobot("fake").onStart(this::offer).onClose(() -> order.add("old closed"));
  private final FakeRobot other = new FakeRobot("other").onStart(this::offerOther);
  private final FakeRobot arm = new FakeRobot("arm");
  private final FakeView map = new FakeView("map", Samples.SCAN);
  private final FakeView teleop = new FakeView("teleop", Samples.VELOCITY);

  @BeforeEach
  void start() {
    bench = new CoreBench(folder);
    bench.registry.add(robot, "org.robotui.rfic.fake");
    bench.registry.add(other, "org.robotui.rfic.other");
    bench.registry.add(arm, "org.robotui.rfic.arm");
    bench.registry.add(map, "org.robotui.uic.map");
    bench.registry.add(teleop, "org.robotui.uic.teleop");
  }

  @AfterEach
  void end() {
    bench.close();
  }

  private void offer(RficContext context) {
    oldScans.add(context.offers().stream(Samples.SCAN, Demand.IGNORED));
    context.offers().command(Samples.VELOCITY, command -> {
      sent.add(command);
      order.add(command.equals(VelocityCommand.ZERO) ? "zero" : "moves");
      return new Sent.Out();
    });
    context.link().report(new LinkState.Connected("robot"));
  }

  private void offerOther(RficContext context) {
    order.add("new started");
    newScans.add(context.offers().stream(LASER, Demand.IGNORED));
    context.offers().command(Samples.VELOCITY, command -> new Sent.Out());
    context.link().report(new LinkState.Connected("other robot"));
  }

  private Ruic running() {
    assertEquals(List.of(), bench.load(YAML));
    Ruic ruic = bench.ruic();
    Await.until("all is connected",
        () -> connected("map.scan", "base.scan") && connected("teleop.cmd_vel", "base.cmd_vel"));
    return ruic;
  }

  private boolean connected(String port, String peer) {
    return bench.match(port)
        .filter(m -> m.state() == MatchState.CONNECTED && m.peers().toString().equals("[" + peer + "]")).isPresent();
  }

  private static InterfaceConfig as(String type) {
    return new InterfaceConfig("base", type, "pioneer", "", Map.of("peer", "second"));
  }

  private static ExchangePreview decided(Exchange exchange) {
    Await.until("the trial has been decided", () -> exchange.preview().verdict() != Verdict.PENDING);
    return exchange.preview();
  }

  private static ExchangeOutcome apply(Exchange exchange, boolean goWithout) throws Exception {
    return exchange.apply(goWithout).toCompletableFuture().get(20, TimeUnit.SECONDS);
  }

  @Test
  void whatCoversAllThatIsUsedTakesThePlaceWhileTheViewsGoOn() throws Exception {
    Ruic ruic = running();
    Object before = ruic.uic("map").orElseThrow();
    Exchange exchange = ruic.exchange(as("other"));
    ExchangePreview preview = decided(exchange);
    assertEquals(Verdict.READY, preview.verdict(), preview.sentence());
    Line scan = preview.lines().getFirst();
    assertEquals(List.of(new SourceId("base", "scan")), scan.now().peers());
    assertEquals(List.of(new SourceId("base", "laser:0")), scan.then().peers());
    assertTrue(connected("map.scan", "base.scan"), "nothing changes before it is applied");

    assertInstanceOf(ExchangeOutcome.Done.class, apply(exchange, false));

    assertTrue(connected("map.scan", "base.laser:0") && connected("teleop.cmd_vel", "base.cmd_vel"));
    assertSame(before, ruic.uic("map").orElseThrow());
    assertEquals(0, map.closed.get());
    assertEquals(1, robot.closed.get());
    assertEquals("other", bench.status("base").type());
    assertEquals(1, other.closed.get(), "the trial has ended, the one that stays has not");
    assertEquals(2, other.contexts.size());
  }

  @Test
  void whatDoesNotCoverAUsedConnectionIsRefusedAndNamesIt() throws Exception {
    Ruic ruic = running();
    other.onStart(c -> {
      c.offers().stream(LASER, Demand.IGNORED);
      c.link().report(new LinkState.Connected("other robot"));
    });
    Exchange exchange = ruic.exchange(as("other"));
    assertEquals(Verdict.PENDING, exchange.preview().verdict(), "what is missing may still be found");
    ExchangePreview preview = decided(exchange);
    assertEquals(Verdict.INCOMPLETE, preview.verdict());
    assertEquals(List.of("teleop sends VelocityCommand on 'cmd_vel'; the replacement has nothing that fits"),
        preview.missing());
    assertEquals(List.of("teleop.cmd_vel"),
        preview.lines().stream().filter(Line::lost).map(l -> l.now().port().toString()).toList());

    ExchangeOutcome.Refused refused = assertInstanceOf(ExchangeOutcome.Refused.class, apply(exchange, false));
    assertTrue(refused.reason().contains("teleop sends VelocityCommand"), refused.reason());
    assertTrue(connected("teleop.cmd_vel", "base.cmd_vel"));
    assertEquals(0, robot.closed.get());

    assertInstanceOf(ExchangeOutcome.Done.class, apply(exchange, true));
    assertTrue(connected("map.scan", "base.laser:0"));
    assertEquals(List.of(), bench.match("teleop.cmd_vel").orElseThrow().peers());
  }

  @Test
  void whatWeDriveIsStoppedFirstAndNobodyHoldsTheNewRobot() throws Exception {
    Ruic ruic = running();
    ruic.authorities().getFirst().take(Samples.YOU, false);
    teleop.context().output(Samples.VELOCITY).send(Samples.forward(1), Duration.ofSeconds(60));
    Await.until("it moves", () -> sent.contains(Samples.forward(1)));
    Exchange exchange = ruic.exchange(as("other"));
    decided(exchange);
    assertTrue(sent.stream().noneMatch(VelocityCommand.ZERO::equals), "a trial does not touch what is driven");
    order.clear();
    assertInstanceOf(ExchangeOutcome.Done.class, apply(exchange, false));
    assertEquals("zero", order.getFirst(), order.toString());
    assertTrue(order.indexOf("old closed") < order.lastIndexOf("new started"), order.toString());
    assertTrue(ruic.authorities().getFirst().holder().isEmpty());
    CommandOutcome outcome = teleop.context().output(Samples.VELOCITY).send(Samples.forward(1), Duration.ofMillis(300));
    assertEquals(CommandOutcome.Why.NO_LEASE, assertInstanceOf(CommandOutcome.Refused.class, outcome).why());
  }

  @Test
  void aStopStaysLatched() throws Exception {
    Ruic ruic = running();
    bench.core.stopAll(Samples.YOU);
    Exchange exchange = ruic.exchange(as("other"));
    decided(exchange);
    assertInstanceOf(ExchangeOutcome.Done.class, apply(exchange, false));
    assertTrue(ruic.authorities().getFirst().stoppedBy().isPresent());
  }

  @Test
  void viewsGetAResetAndNothingOfTheOldRobot() throws Exception {
    Ruic ruic = running();
    FrameSink oldFrames = robot.context().frames();
    oldFrames.add(frame("old_laser"), "old");
    oldScans.getFirst().publish(Samples.scan(1), Optional.empty());
    long epoch = ruic.clock().epoch();
    Exchange exchange = ruic.exchange(as("other"));
    decided(exchange);
    other.context().frames().add(frame("tried"), "trial");
    assertEquals(List.of("base", "old_laser"), names(), "a trial adds no frames");
    assertInstanceOf(ExchangeOutcome.Done.class, apply(exchange, false));
    assertEquals(epoch + 1, ruic.clock().epoch());
    oldScans.getFirst().publish(Samples.scan(2), Optional.empty());
    oldFrames.add(frame("late"), "old");
    assertEquals(List.of(), names());
    assertEquals(Optional.empty(), map.context().input(Samples.SCAN).latest());
    newScans.getLast().publish(Samples.scan(3), Optional.empty());
    assertEquals(3, map.context().input(Samples.SCAN).latest().orElseThrow().value().ranges().get(0));
    assertEquals(0, map.context().input(Samples.SCAN).latest().orElseThrow().sequence());
  }

  @Test
  void whatOtherInterfacesSaidForAllTimesIsNotForgotten() throws Exception {
    assertEquals(List.of(), bench.load(YAML.replace("    uics:", "      arm: {type: arm, robot: arm}\n    uics:")));
    Ruic ruic = bench.ruic();
    Await.until("it is connected", () -> connected("map.scan", "base.scan"));
    arm.context().frames()
        .add(new TransformSet(List.of(new FrameTransform(new FrameId("arm", "base"), new FrameId("arm", "plate"),
            new Stamp(1, ClockKind.ROBOT), RigidTransform.IDENTITY, true))), "arm");
    robot.context().frames().add(frame("old_laser"), "old");
    Exchange exchange = ruic.exchange(as("other"));
    decided(exchange);
    assertInstanceOf(ExchangeOutcome.Done.class, apply(exchange, false));
    assertEquals(List.of("base", "plate"), names());
  }

  private List<String> names() {
    return map.context().frames().all().stream().map(FrameId::name).toList();
  }

  private static TransformSet frame(String name) {
    return new TransformSet(List.of(new FrameTransform(new FrameId("pioneer", "base"), new FrameId("pioneer", name),
        new Stamp(1, ClockKind.ROBOT), RigidTransform.IDENTITY, false)));
  }

  @Test
  void whatCannotBeStartedInTheEndGivesWayToTheOldOne() throws Exception {
    Ruic ruic = running();
    Exchange exchange = ruic.exchange(as("other"));
    decided(exchange);
    other.onStart(c -> {
      throw new IllegalStateException("the robot has gone");
    });
    ExchangeOutcome.WentBack back = assertInstanceOf(ExchangeOutcome.WentBack.class, apply(exchange, false));
    assertTrue(back.reason().contains("the robot has gone") && back.reason().endsWith("it is fake again"),
        back.reason());
    assertTrue(connected("map.scan", "base.scan"));
    assertEquals("fake", ruic.interfaces().getFirst().type());
    assertEquals(Optional.empty(), ruic.written("base"));
  }

  @Test
  void whatCannotBeTriedSaysWhy() {
    Ruic ruic = running();
    try (Exchange exchange = ruic.exchange(as("carmen"))) {
      assertEquals(Verdict.FAILED, decided(exchange).verdict());
      assertTrue(
          exchange.preview().sentence().contains("type 'carmen' is not installed; installed are arm, fake, other"),
          exchange.preview().sentence());
    }
    InterfaceConfig slip = new InterfaceConfig("base", "other", "pioneer", "", Map.of("per", "second"));
    try (Exchange exchange = ruic.exchange(slip)) {
      assertTrue(decided(exchange).sentence().contains("did you mean 'peer'"), exchange.preview().sentence());
    }
    assertThrows(IllegalArgumentException.class,
        () -> ruic.exchange(new InterfaceConfig("bse", "other", "", "", Map.of())));
    assertFalse(bench.alerts.stream().anyMatch(a -> a.contains("carmen")), "a trial raises no alert: " + bench.alerts);
  }

  @Test
  void aTrialThatIsClosedLeavesNothing() {
    Ruic ruic = running();
    ruic.exchange(as("other")).close();
    Await.until("it has ended",
        () -> other.closed.get() == other.contexts.size() && CoreBench.threads("trial-").isEmpty());
    assertTrue(connected("map.scan", "base.scan"));
  }

  @Test
  void ofSeveralThatFitTheUserPicks() throws Exception {
    other.onStart(c -> {
      offerOther(c);
      c.offers().stream(new StreamPort<>("laser:1", LaserScan.class, Samples.SCAN.arity(), ""), Demand.IGNORED);
    });
    Ruic ruic = running();
    Exchange exchange = ruic.exchange(as("other"));
    assertEquals(MatchState.AMBIGUOUS, decided(exchange).lines().getFirst().then().state());
    exchange.choose(new SourceId("map", "scan"), new SourceId("base", "laser:1"));
    assertEquals(MatchState.CONNECTED, exchange.preview().lines().getFirst().then().state());
    assertInstanceOf(ExchangeOutcome.Done.class, apply(exchange, false));
    assertTrue(connected("map.scan", "base.laser:1"));
  }

  @Test
  void whatWasExchangedIsKeptAndCanGoBackToTheFile() throws Exception {
    Ruic ruic = running();
    Exchange exchange = ruic.exchange(as("other"));
    decided(exchange);
    apply(exchange, false);
    ruic.connect(new SourceId("map", "scan"), new SourceId("base", "laser:0"));
    bench.close();
    start();
    bench.load(YAML);
    Ruic again = bench.ruic();
    Await.until("it is the other one again", () -> connected("map.scan", "base.laser:0"));
    assertEquals(as("other"), again.interfaces().getFirst());
    InterfaceConfig written = again.written("base").orElseThrow();
    assertEquals(Map.of("peer", "first"), written.settings());

    Exchange back = again.exchange(written);
    ExchangePreview preview = decided(back);
    assertEquals(Verdict.READY, preview.verdict());
    assertEquals(List.of(new SourceId("base", "scan")), preview.lines().getFirst().then().peers(),
        "a choice that leads nowhere gives way to what fits");
    assertInstanceOf(ExchangeOutcome.Done.class, apply(back, false));
    assertTrue(connected("map.scan", "base.scan"));
    assertEquals(Optional.empty(), again.written("base"));
  }
}
