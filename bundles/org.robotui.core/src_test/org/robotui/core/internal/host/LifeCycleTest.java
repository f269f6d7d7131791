package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.RficContext;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.core.internal.support.Samples;
import org.robotui.data.sensor.LaserScan;

class LifeCycleTest {
  private static final String YAML = """
      ruics:
        hanging:
          rfics:
            base: {type: fake}
            second: {type: good}
          uics:
            map: {type: map}
      """;

  @TempDir
  Path folder;

  private CoreBench bench;
  private final FakeRobot robot = new FakeRobot("fake");
  private final FakeRobot good = new FakeRobot("good");
  private final FakeView map = new FakeView("map", Samples.SCAN);

  @BeforeEach
  void start() {
    bench = new CoreBench(folder);
    bench.registry.add(robot, "org.robotui.rfic.fake");
    bench.registry.add(good, "org.robotui.rfic.good");
    bench.registry.add(map, "org.robotui.uic.map");
  }

  @AfterEach
  void end() {
    bench.close();
  }

  private Ruic running() {
    assertEquals(List.of(), bench.load(YAML));
    return bench.ruic();
  }

  private static void hang() {
    try {
      new CountDownLatch(1).await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static void assertNoThreadIsLeft() {
    Await.until("no thread is left, not " + CoreBench.threads("hanging"), () -> CoreBench.threads("hanging").isEmpty()
        && CoreBench.threads("ruic-hanging").isEmpty() && CoreBench.threads("arbiter-hanging").isEmpty());
  }

  @Test
  void hangingCloseIsReportedAndLeavesNoThread() {
    robot.onStart(c -> c.threads().newThread(LifeCycleTest::hang).start()).onClose(LifeCycleTest::hang);
    running();
    List<String> left = bench.core.close(Duration.ofSeconds(5));
    assertEquals(1, left.size(), left.toString());
    assertTrue(left.getFirst().startsWith("base did not return from close within 2.0 s"), left.getFirst());
    assertTrue(left.getFirst().contains("bundle org.robotui.rfic.fake"), left.getFirst());
    assertEquals(1, good.closed.get());
    assertNoThreadIsLeft();
  }

  @Test
  void threadThatCannotBeEndedIsNamed() {
    AtomicBoolean over = new AtomicBoolean();
    robot.onStart(c -> c.threads().newThread(() -> {
      while (!over.get()) {
        LockSupport.parkNanos(1_000_000); // deaf to interrupts
      }
    }).start());
    running();
    List<String> left = bench.core.close(Duration.ofSeconds(5));
    over.set(true);
    assertTrue(left.getFirst().contains("threads left: hanging.base-"), left.toString());
  }

  @Test
  void closeIsShortWhenItMustBe() {
    robot.onClose(LifeCycleTest::hang);
    running();
    long start = System.nanoTime();
    bench.core.close(Duration.ofMillis(200)); // without a bound it takes two seconds
    assertTrue(System.nanoTime() - start < TimeUnit.MILLISECONDS.toNanos(1900));
  }

  @Test
  void interfacesCloseAtTheSameTime() {
    robot.onClose(LifeCycleTest::hang);
    good.onClose(LifeCycleTest::hang);
    running();
    long start = System.nanoTime();
    assertEquals(2, bench.core.close(Duration.ofSeconds(10)).size());
    assertTrue(System.nanoTime() - start < TimeUnit.MILLISECONDS.toNanos(3500), "not one after the other");
  }

  @Test
  void aTeamIsGivenTheTimeItsRobotsNeed() {
    robot.onClose(() -> LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1000)));
    assertEquals(List.of(), bench.load("""
        ruics:
          hanging:
            rfics:
              ${robot}: {for: r1..r40, type: fake}
            uics:
              map: {type: map}
        """));
    bench.await("r40", RuicState.INITIALIZED);
    assertEquals(Duration.ofMillis(2100), bench.core.closeLimit(Duration.ofMillis(1200)));
    assertEquals(List.of(), bench.core.close(Duration.ofMillis(1200)));
    assertEquals(40, robot.closed.get());
  }

  @Test
  void interfaceThatHangsInStartFailsAndTheOthersGoOn() {
    robot.onStart(c -> hang());
    running();
    bench.await("base", RuicState.FAILED);
    String reason = bench.status("base").reason();
    assertTrue(reason.contains("did not return from start within 10.0 s"), reason);
    bench.await("second", RuicState.INITIALIZED);
    bench.await("map", RuicState.INITIALIZED);
    assertEquals(1, robot.closed.get(), "it is closed, also when its start failed");
  }

  @Test
  void interfaceThatThrowsInCreateFailsAndCanBeRestarted() {
    robot.onCreate(c -> {
      throw new IllegalArgumentException("no such device");
    });
    Ruic ruic = running();
    bench.await("base", RuicState.FAILED);
    assertTrue(bench.status("base").reason().contains("no such device"));
    robot.onCreate(c -> {});
    ruic.restart("base");
    bench.await("base", RuicState.INITIALIZED);
  }

  @Test
  void restartMakesNewInstancesOfAll() throws Exception {
    Ruic ruic = running();
    ruic.select("window");
    bench.await("map", RuicState.SELECTED);
    assertEquals(RuicState.SELECTED, ruic.restart().toCompletableFuture().get());
    assertEquals(2, robot.contexts.size());
    assertEquals(1, robot.closed.get());
    assertEquals(2, map.contexts.size());
    assertEquals(1, map.closed.get());
  }

  @Test
  void restartAfterRemovalEndsToo() throws Exception {
    Ruic ruic = running();
    ruic.remove().toCompletableFuture().get();
    assertEquals(RuicState.SHUT_DOWN, ruic.restart().toCompletableFuture().get(5, TimeUnit.SECONDS));
    assertEquals(1, robot.contexts.size());
  }

  @Test
  void surfaceThatFailedMakesItsViewFail() {
    Ruic ruic = running();
    ruic.surfaceFailed("map", "painting threw");
    bench.await("map", RuicState.FAILED);
    String reason = bench.status("map").reason();
    assertTrue(reason.startsWith("painting threw (bundle org.robotui.uic.map, class "), reason);
    assertTrue(ruic.uic("map").isEmpty());
  }

  @Test
  void offersComeAndGoWhileItRuns() {
    robot.onStart(c -> c.link().report(new LinkState.Connected("robot")));
    running();
    RficContext context = robot.context();
    Publication<LaserScan> scans = context.offers().stream(Samples.SCAN, Demand.IGNORED);
    Await.until("connected", () -> map.context().input(Samples.SCAN).sources().size() == 1);
    scans.close();
    Await.until("disconnected", () -> map.context().input(Samples.SCAN).sources().isEmpty());
    context.offers().stream(Samples.SCAN, Demand.IGNORED);
    Await.until("connected again", () -> map.context().input(Samples.SCAN).sources().size() == 1);
  }

  @Test
  void whatIsMissingIsPendingFirstAndRefusedWhenTheInterfaceHasSettled() {
    robot.onStart(c -> c.link().report(new LinkState.Connected("robot")));
    good.onStart(c -> c.link().report(new LinkState.Connected("robot")));
    running();
    Await.until("pending", () -> bench.match("map.scan").orElseThrow().reason().contains("still looking"));
    Await.until("refused", () -> bench.match("map.scan").orElseThrow().reason()
        .equals("map needs LaserScan on 'scan'; base has no stream; second has no stream"));
  }

  @Test
  void givenUpInstanceMayStillOffer() {
    running();
    RficContext context = robot.context();
    bench.registry.remove(robot);
    bench.await("base", RuicState.FAILED);
    Await.until("closed", () -> robot.closed.get() == 1);
    context.offers().stream(Samples.SCAN, Demand.IGNORED);
    assertEquals(0, map.context().input(Samples.SCAN).sources().size());
  }

  @Test
  void viewThatBlocksWhenItIsAnsweredHoldsUpNoTimeOutOfOthers() throws Exception {
    FakeView other = new FakeView("other", Samples.CALL);
    FakeView blocking = new FakeView("blocking", Samples.CALL);
    bench.registry.add(other, "org.robotui.uic.other");
    bench.registry.add(blocking, "org.robotui.uic.blocking");
    robot.onStart(c -> c.offers().call(Samples.CALL, i -> {
      new CountDownLatch(1).await();
      throw new IllegalStateException("never");
    }));
    assertEquals(List.of(),
        bench.load(YAML.replace("map: {type: map}", "a: {type: blocking}\n      b: {type: other}")));
    bench.await("b", RuicState.INITIALIZED);
    CountDownLatch blocks = new CountDownLatch(1);
    ask(blocking).thenAccept(outcome -> {
      blocks.countDown();
      hang();
    });
    assertTrue(blocks.await(5, TimeUnit.SECONDS), "it is answered, and blocks");
    assertEquals(new CallOutcome.TimedOut<>(), ask(other).toCompletableFuture().get(5, TimeUnit.SECONDS));
  }

  private static CompletionStage<CallOutcome<ServiceReply>> ask(FakeView view) {
    Await.until("it is connected", () -> !view.context().caller(Samples.CALL).targets().isEmpty());
    return view.context().caller(Samples.CALL)
        .call(new ServiceRequest("/ask", Map.of()), Duration.ofMillis(50), Progress.IGNORED).outcome();
  }

  @Test
  void displayThatHangsIsReportedWithItsBundleAndRemembered() throws Exception {
    running();
    CountDownLatch over = new CountDownLatch(1);
    Thread display = Thread.ofPlatform().daemon().start(() -> {
      bench.core.displayAlive();
      awaitQuietly(over);
    });
    Await.until("it is reported", () -> bench.alerts.stream().anyMatch(a -> a.contains("bundle org.robotui.uic.bad")));
    Path file = folder.resolve("state").resolve("suspect-bundles.txt");
    assertFalse(Files.exists(file), "a busy machine may explain it so far");
    Await.until("it is remembered", () -> file.toFile().length() > 0);
    over.countDown();
    display.join();
    assertEquals(List.of("org.robotui.uic.bad"), Files.readAllLines(file));
  }

  private static void awaitQuietly(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
