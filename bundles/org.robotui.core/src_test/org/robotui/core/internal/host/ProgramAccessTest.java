package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.RficContext;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.CommandOutcome.Refused;
import org.robotui.api.command.CommandOutcome.Why;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.core.internal.support.Samples;
import org.robotui.data.Data;
import org.robotui.data.array.Bytes;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.LaserScan;

class ProgramAccessTest {
  private static final String YAML = """
      ruics:
        pioneer:
          rfics:
            base:
              type: fake
          uics:
            empty: {}
      """;
  private static final SourceId SCAN = new SourceId("base", "scan");
  private static final SourceId VELOCITY = new SourceId("base", "cmd_vel");
  private static final SourceId CALL = new SourceId("base", "call");
  private static final Duration VALID = Duration.ofMillis(200);

  @TempDir
  private Path folder;
  private final FakeRobot robot = new FakeRobot("fake");
  private final List<Data> sent = new CopyOnWriteArrayList<>();
  private final AtomicReference<Publication<LaserScan>> scans = new AtomicReference<>();
  private final List<Boolean> demand = new CopyOnWriteArrayList<>();
  private CoreBench bench;
  private Ruic ruic;
  private PortAccess access;

  @BeforeEach
  void start() {
    bench = new CoreBench(folder);
    robot.onStart(this::offer);
    bench.registry.add(robot, "org.robotui.rfic.fake");
    bench.registry.add(new FakeView("empty"), "org.robotui.uic.empty");
    assertEquals(List.of(), bench.load(YAML));
    ruic = bench.ruic();
    Await.until("the robot is there", () -> !ruic.snapshot().ports().isEmpty());
    access = ruic.access(Samples.SCRIPT);
  }

  @AfterEach
  void end() {
    bench.close();
  }

  private void offer(RficContext context) {
    scans.set(context.offers().stream(Samples.SCAN, demand::add));
    context.offers().command(Samples.VELOCITY, command -> {
      sent.add(command);
      return new Sent.Out();
    });
    context.offers().call(Samples.CALL,
        invocation -> new ServiceReply(new MapRecord(invocation.request().service(), Map.of())));
    context.link().report(new LinkState.Connected("robot"));
  }

  private void publish(float range) {
    scans.get().publish(Samples.scan(range), Optional.empty(), System.nanoTime(), Optional.empty());
  }

  private static Why why(CommandOutcome outcome) {
    return assertInstanceOf(Refused.class, outcome).why();
  }

  @Test
  void whoRecordsLearnsWhetherAStreamConsistsOfMessagesAndWhichHold() {
    RawMessage raw = new RawMessage("Scan", "cdr", Bytes.of((byte) 1), RawMessage.Reader.NONE);
    publish(1);
    assertEquals(Optional.empty(), access.held(SCAN));
    scans.get().publish(Samples.scan(2), Optional.empty(), System.nanoTime(), Optional.of(raw));
    assertEquals(Optional.of(List.of()), access.held(SCAN));
    scans.get().held(() -> List.of(raw));
    assertEquals(Optional.of(List.of(raw)), access.held(SCAN));
    assertEquals(Optional.empty(), access.held(new SourceId("base", "nothing")));
  }

  @Test
  void theRobotIsAskedOnlyForWhatIsRead() {
    assertEquals(List.of(), demand);
    assertEquals(Optional.empty(), access.newest(SCAN));
    assertInstanceOf(InputState.Waiting.class, access.state(SCAN));
    Await.until("the robot is asked", () -> demand.equals(List.of(true)));
    publish(1);
    assertEquals(Samples.scan(1), access.newest(SCAN).orElseThrow().value());
    access.close();
    Await.until("the robot is asked no more", () -> demand.equals(List.of(true, false)));
    assertEquals(Optional.empty(), access.newest(SCAN));
  }

  @Test
  void whoTakesIsToldOfEachValueThatWaits() {
    AtomicInteger told = new AtomicInteger();
    access.onArrival(told::incrementAndGet);
    publish(1);
    assertEquals(0, told.get(), "nothing is taken yet");
    access.take(SCAN, value -> {});
    told.set(0);
    publish(2);
    publish(3);
    assertEquals(2, told.get(), "by the thread that publishes");
    access.close();
    publish(4);
    assertEquals(2, told.get());
  }

  @Test
  void everyValueCanBeTaken() {
    List<Object> taken = new ArrayList<>();
    assertEquals(0, access.take(SCAN, e -> taken.add(e.value())));
    publish(1);
    publish(2);
    assertEquals(2, access.take(SCAN, e -> taken.add(e.value())));
    assertEquals(List.of(Samples.scan(1), Samples.scan(2)), taken);
  }

  @Test
  void whatIsNotThereIsNamed() {
    SourceId nothing = new SourceId("base", "nothing");
    assertEquals("no stream base.nothing is offered now", access.state(nothing).explanation());
    assertEquals(Optional.empty(), access.port(PortKind.COMMAND, nothing));
    assertEquals(Why.NOT_CONNECTED, why(access.send(nothing, VelocityCommand.ZERO, VALID)));
    assertTrue(assertInstanceOf(Refused.class, access.send(VELOCITY, Samples.goal(1), VALID)).explanation()
        .contains("takes VelocityCommand"));
    assertEquals(Optional.empty(), access.browser(nothing));
  }

  @Test
  void commandsPassTheArbiter() {
    assertEquals(Why.NO_LEASE, why(access.send(VELOCITY, Samples.forward(1), VALID)));
    ruic.authorities().getFirst().take(Samples.SCRIPT, false);
    assertEquals(new CommandOutcome.Accepted(), access.send(VELOCITY, Samples.forward(1), VALID));
    Await.until("zero follows when it is not renewed", () -> sent.contains(VelocityCommand.ZERO));
    ruic.authorities().getFirst().stop(Samples.YOU);
    assertEquals(Why.STOPPED, why(access.send(VELOCITY, Samples.forward(1), VALID)));
  }

  @Test
  void theEndStopsWhatWasMoved() {
    ruic.authorities().getFirst().take(Samples.SCRIPT, false);
    access.send(VELOCITY, Samples.forward(1), Duration.ofMinutes(1));
    Await.until("it moves", () -> sent.equals(List.of(Samples.forward(1))));
    access.close();
    Await.until("it is stopped", () -> sent.contains(VelocityCommand.ZERO));
    assertEquals(Why.NOT_CONNECTED, why(access.send(VELOCITY, Samples.forward(1), VALID)));
  }

  @Test
  void callsAreAnswered() throws Exception {
    CallOutcome<?> outcome = access.call(CALL, new ServiceRequest("/reset", Map.of()), VALID.multipliedBy(50),
        Progress.IGNORED).outcome().toCompletableFuture().get(20, TimeUnit.SECONDS);
    assertEquals("/reset",
        ((ServiceReply) assertInstanceOf(CallOutcome.Replied.class, outcome).reply()).value().schema());
    assertEquals(new CallOutcome.Failed<>("base.call takes ServiceRequest"),
        access.call(CALL, "what", VALID, Progress.IGNORED).outcome().toCompletableFuture().get(20, TimeUnit.SECONDS));
  }

  @Test
  void portsThatComeAnewAreFound() throws Exception {
    access.newest(SCAN);
    ruic.restart().toCompletableFuture().get(20, TimeUnit.SECONDS);
    access.newest(SCAN);
    publish(3);
    assertEquals(Samples.scan(3), access.newest(SCAN).orElseThrow().value());
  }
}
