package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.RficContext;
import org.robotui.api.UicType.Surface;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.Demand;
import org.robotui.api.port.InputState;
import org.robotui.api.port.Publication;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.core.internal.support.Samples;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.sensor.LaserScan;

class CoreTest {
  private static final String YAML = """
      ruics:
        pioneer:
          rfics:
            base:
              type: fake
          uics:
            map:
              type: map
            teleop:
              type: teleop
      """;

  @TempDir
  Path folder;

  private CoreBench bench;
  private final AtomicReference<Publication<LaserScan>> scans = new AtomicReference<>();
  private final List<VelocityCommand> sent = new CopyOnWriteArrayList<>();
  private final FakeRobot robot = new FakeRobot("fake").onStart(this::offer);
  private final FakeView map = new FakeView("map", Samples.SCAN).onTick(c -> c.input(Samples.SCAN).drain(e -> {}) > 0);
  private final FakeView teleop = new FakeView("teleop", Samples.VELOCITY);

  @BeforeEach
  void start() {
    bench = new CoreBench(folder);
    bench.registry.add(robot, "org.robotui.rfic.fake");
    bench.registry.add(map, "org.robotui.uic.map");
    bench.registry.add(teleop, "org.robotui.uic.teleop");
  }

  @AfterEach
  void end() {
    bench.close();
  }

  private void offer(RficContext context) {
    scans.set(context.offers().stream(Samples.SCAN, Demand.IGNORED));
    context.offers().command(Samples.VELOCITY, command -> {
      sent.add(command);
      return new Sent.Out();
    });
    context.link().report(new LinkState.Connected("robot"));
  }

  private Ruic running() {
    assertEquals(List.of(), bench.load(YAML));
    Ruic ruic = bench.ruic();
    Await.until("the scan is connected", this::scanIsConnected);
    return ruic;
  }

  private boolean scanIsConnected() {
    return bench.match("map.scan").filter(m -> m.state() == MatchState.CONNECTED).isPresent();
  }

  @Test
  void dataFlowsFromRobotToSelectedView() {
    Ruic ruic = running();
    ruic.select("window");
    bench.await("map", RuicState.SELECTED);
    scans.get().publish(Samples.scan(1), Optional.empty());
    Await.until("a frame is ready", () -> bench.frames.contains("map"));
    assertInstanceOf(InputState.Live.class, map.context().input(Samples.SCAN).state());
    PortStatus port = ruic.snapshot().ports().getFirst();
    assertEquals(1, port.count());
    assertEquals("1 beams, min 1.00 m", port.value());
    assertTrue(port.wanted());
  }

  @Test
  void unselectedViewsDoNotTick() {
    Ruic ruic = running();
    ruic.select("one");
    ruic.select("two");
    Await.until("the view ticks", () -> map.ticks.get() > 0);
    ruic.unselect("one");
    bench.await("map", RuicState.SELECTED);
    ruic.unselect("two");
    bench.await("map", RuicState.UNSELECTED);
    int ticks = map.ticks.get();
    bench.await("base", RuicState.INITIALIZED);
    assertTrue(map.ticks.get() - ticks <= 1, "at most the tick that was under way");
  }

  @Test
  void commandsNeedTheLeaseAndReachTheRobot() {
    Ruic ruic = running();
    Output<VelocityCommand> output = teleop.context().output(Samples.VELOCITY);
    CommandOutcome refused = output.send(Samples.forward(1), Duration.ofMillis(300));
    assertEquals(CommandOutcome.Why.NO_LEASE, assertInstanceOf(CommandOutcome.Refused.class, refused).why());
    ruic.authorities().getFirst().take(Samples.YOU, false);
    assertEquals(new CommandOutcome.Accepted(), output.send(Samples.forward(1), Duration.ofMillis(100)));
    Await.until("zero follows when it is not renewed", () -> sent.size() == 4);
    assertEquals(
        List.of(Samples.forward(1), VelocityCommand.ZERO, VelocityCommand.ZERO, VelocityCommand.ZERO), sent);
  }

  @Test
  void stopIsSaidAlsoToWhatWeNeverCommandedAndHoldsUntilReleased() {
    Ruic ruic = running();
    bench.core.stopAll(Samples.YOU);
    Await.until("zero is sent", () -> sent.contains(VelocityCommand.ZERO));
    ruic.authorities().getFirst().take(Samples.YOU, false);
    CommandOutcome refused = teleop.context().output(Samples.VELOCITY).send(Samples.forward(1), Duration.ofMillis(300));
    assertEquals(CommandOutcome.Why.STOPPED, assertInstanceOf(CommandOutcome.Refused.class, refused).why());
    ruic.authorities().getFirst().releaseStop(Samples.YOU);
    assertEquals(new CommandOutcome.Accepted(),
        teleop.context().output(Samples.VELOCITY).send(Samples.forward(1), Duration.ofMillis(300)));
    assertTrue(sent.stream().allMatch(c -> c.equals(VelocityCommand.ZERO) || c.equals(Samples.forward(1))));
  }

  @Test
  void stopStaysLatchedOverARestart() throws Exception {
    Ruic ruic = running();
    bench.core.stopAll(Samples.YOU);
    Await.until("zero is sent", () -> sent.size() == 1);
    ruic.restart().toCompletableFuture().get();
    assertTrue(ruic.authorities().getFirst().stoppedBy().isPresent());
    Await.until("the new instance is stopped, too", () -> sent.size() > 1);
  }

  @Test
  void aStopFromOutsideWorksWhileTheDisplayHangs() throws IOException {
    Ruic ruic = running();
    bench.core.displayAlive(); // and never again
    String told = bench.stopFromOutside();
    assertTrue(told.contains("nothing was driven from here") && told.endsWith("done\n"), told);
    Await.until("zero is sent", () -> sent.contains(VelocityCommand.ZERO));
    assertEquals("./robotui stop", ruic.authorities().getFirst().stoppedBy().orElseThrow().label());
    assertTrue(bench.stopFromOutside().contains("it was already, by ./robotui stop"));
  }

  @Test
  void theNextStartTellsOfAStopThatWasLatchedWhenTheProcessEnded() throws IOException {
    running();
    bench.core.stopAll(Samples.YOU);
    Path own = folder.resolve("state/run/left-" + ProcessHandle.current().pid() + ".txt");
    Await.until("it is written", () -> Files.exists(own));
    bench.close();
    Files.move(own, own.resolveSibling("left-999999999.txt"));
    bench = new CoreBench(folder);
    bench.load(YAML);
    Await.until("it is told",
        () -> bench.alerts.stream().anyMatch(a -> a.contains("process 999999999") && a.contains("was stopped by")));
  }

  @Test
  void closingStopsWhatWeDriveAndOnlyThat() {
    Ruic ruic = running();
    ruic.authorities().getFirst().take(Samples.YOU, false);
    teleop.context().output(Samples.VELOCITY).send(Samples.forward(1), Duration.ofSeconds(60));
    Await.until("it moves", () -> sent.contains(Samples.forward(1)));
    assertEquals(List.of(), bench.core.close(Duration.ofSeconds(5)));
    assertEquals(VelocityCommand.ZERO, sent.getLast());
  }

  @Test
  void closingSendsNothingWhereWeDidNotMove() {
    running();
    assertEquals(List.of(), bench.core.close(Duration.ofSeconds(5)));
    assertEquals(List.of(), sent);
    assertEquals(1, robot.closed.get());
  }

  @Test
  void typeThatVanishesFailsItsComponentsAndRecoversThem() {
    Ruic ruic = running();
    bench.registry.remove(map).join();
    assertEquals(1, map.closed.get(), "nothing of it runs when its bundle may go");
    bench.await("map", RuicState.FAILED);
    assertEquals("type 'map' is not there; install or start bundle org.robotui.uic.map", bench.status("map").reason());
    assertTrue(ruic.uic("map").isEmpty());
    bench.registry.add(map, "org.robotui.uic.map");
    bench.await("map", RuicState.INITIALIZED);
    Await.until("connected again", this::scanIsConnected);
    assertEquals(2, map.contexts.size());
  }

  @Test
  void robotInterfaceTypeThatVanishesIsShownAndRecovers() {
    running();
    bench.registry.remove(robot);
    bench.await("base", RuicState.FAILED);
    Await.until("the view says so", () -> bench.match("map.scan").orElseThrow().state() == MatchState.PENDING);
    assertTrue(
        bench.match("map.scan").orElseThrow().reason().contains("install or start bundle org.robotui.rfic.fake"));
    bench.registry.add(robot, "org.robotui.rfic.fake");
    Await.until("connected again", () -> bench.match("map.scan").orElseThrow().state() == MatchState.CONNECTED);
  }

  @Test
  void typeUnknownAtLoadIsAwaited() {
    bench.registry.remove(map);
    bench.load(YAML);
    bench.ruic();
    bench.await("map", RuicState.FAILED);
    bench.registry.add(map, "org.robotui.uic.map");
    bench.await("map", RuicState.INITIALIZED);
  }

  @Test
  void viewThatThrowsIsFencedAndTheOthersGoOn() {
    map.onTick(c -> {
      throw new IllegalStateException("broken");
    });
    Ruic ruic = running();
    ruic.select("window");
    bench.await("map", RuicState.FAILED);
    String reason = bench.status("map").reason();
    assertTrue(reason.contains("broken") && reason.contains("org.robotui.uic.map") && reason.contains("FakeView"),
        reason);
    int ticks = teleop.ticks.get();
    Await.until("the other ticks", () -> teleop.ticks.get() > ticks + 2);
    map.onTick(c -> false);
    ruic.restart("map");
    bench.await("map", RuicState.SELECTED);
  }

  @Test
  void viewThatHangsIsFencedAndItsThreadInterrupted() {
    CountDownLatch never = new CountDownLatch(1);
    AtomicBoolean ticked = new AtomicBoolean();
    map.onTick(c -> {
      try {
        if (ticked.getAndSet(true)) {
          never.await();
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      return false;
    });
    Ruic ruic = running();
    ruic.select("window");
    Await.until("it is told", () -> bench.alerts
        .contains("The view 'Fake view' took longer than 2 s to answer; it is started again in 2 s."));
    Await.until("its thread has ended", () -> CoreBench.threads("pioneer.map").isEmpty());
    bench.await("teleop", RuicState.SELECTED);
  }

  @Test
  void viewThatWasOnlyLateIsStartedAgainByItself() {
    AtomicBoolean late = new AtomicBoolean(true);
    AtomicInteger answers = new AtomicInteger();
    map.onTick(c -> {
      if (answers.incrementAndGet() > 1 && late.getAndSet(false)) {
        LockSupport.park(); // until it is interrupted
      }
      return false;
    });
    Ruic ruic = running();
    ruic.select("window");
    Await.until("it is started again", () -> map.contexts.size() == 2);
    int before = answers.get();
    Await.until("it answers again", () -> answers.get() > before + 1);
    bench.await("map", RuicState.SELECTED);
    assertEquals(Optional.of(1), map.contexts.getLast().retained(Integer.class),
        "it goes on with what the first one retained");
    assertEquals(Optional.empty(), map.contexts.getLast().retained(String.class), "of another type it gets nothing");
    ruic.restart("map");
    Await.until("the user has started it", () -> map.contexts.size() == 3);
    assertEquals(Optional.empty(), map.contexts.getLast().retained(Integer.class),
        "who is started by the user begins anew");
  }

  @Test
  void viewThatHoldsItsThreadIsNotStartedBesideIt() {
    AtomicBoolean holds = new AtomicBoolean(true);
    AtomicInteger answers = new AtomicInteger();
    map.onTick(c -> {
      while (answers.incrementAndGet() > 1 && holds.get()) {
        LockSupport.parkNanos(1_000_000); // deaf to interrupts
        Thread.interrupted();
      }
      return false;
    });
    Ruic ruic = running();
    ruic.select("window");
    Await.until("it was looked at again",
        () -> bench.status("map").reason().startsWith("The view 'Fake view' still does not answer"));
    assertEquals(1, map.contexts.size());
    holds.set(false);
    bench.await("map", RuicState.SELECTED);
    assertEquals(2, map.contexts.size());
  }

  @Test
  void threadOfARobotInterfaceThatThrowsFailsIt() {
    Ruic ruic = running();
    robot.context().threads().newThread(() -> {
      throw new IllegalStateException("socket code is broken");
    }).start();
    bench.await("base", RuicState.FAILED);
    assertTrue(bench.status("base").reason().contains("socket code is broken"));
    assertEquals("base", ruic.snapshot().components().getFirst().id());
  }

  @Test
  void lostLinkMakesViewsStaleAtOnce() {
    running();
    scans.get().publish(Samples.scan(1), Optional.empty());
    robot.context().link().report(new LinkState.Failed("robot: connection reset", Duration.ofSeconds(1)));
    InputState state = map.context().input(Samples.SCAN).state();
    assertTrue(assertInstanceOf(InputState.Stale.class, state).explanation().contains("connection reset"));
  }

  @Test
  void chosenPeerIsConnectedAndKeptAcrossARestartOfTheProcess() {
    robot.onStart(c -> {
      offer(c);
      c.offers().stream(new StreamPort<>("rear", LaserScan.class, Samples.SCAN.arity(), ""), Demand.IGNORED);
    });
    Ruic ruic = running();
    assertEquals(List.of(new SourceId("base", "scan")), bench.match("map.scan").orElseThrow().peers());
    ruic.connect(new SourceId("map", "scan"), new SourceId("base", "rear"));
    List<SourceId> rear = List.of(new SourceId("base", "rear"));
    Await.until("it is connected", () -> bench.match("map.scan").orElseThrow().peers().equals(rear));
    ruic.settings("map").orElseThrow().set("zoom", 20.0);
    assertEquals(20.0, map.context().settings().current().number("zoom"));
    bench.close();
    start();
    running();
    assertEquals(List.of(new SourceId("base", "rear")), bench.match("map.scan").orElseThrow().peers());
    assertEquals(20.0, map.context().settings().current().number("zoom"));
  }

  @Test
  void viewsForAnotherSurfaceAreLeftOut() {
    teleop.on(Surface.TEXT);
    Ruic ruic = running();
    assertEquals(List.of("base", "map"), ruic.snapshot().components().stream().map(c -> c.id()).toList());
    assertEquals(0, teleop.contexts.size());
    bench.registry.remove(teleop);
    bench.registry.remove(map);
    bench.await("map", RuicState.FAILED);
    assertEquals(List.of("base", "map"), ruic.snapshot().components().stream().map(c -> c.id()).toList());
  }

  @Test
  void removedRuicLeavesNoThread() throws Exception {
    Ruic ruic = running();
    ruic.select("window");
    assertEquals(RuicState.SHUT_DOWN, ruic.remove().toCompletableFuture().get());
    assertEquals(List.of(), bench.core.ruics());
    Await.until("no thread is left",
        () -> CoreBench.threads("pioneer").isEmpty() && CoreBench.threads("ruic-").isEmpty()
            && CoreBench.threads("arbiter-pioneer").isEmpty());
  }
}
