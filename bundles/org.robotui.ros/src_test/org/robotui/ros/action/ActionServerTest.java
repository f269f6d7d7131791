package org.robotui.ros.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageException;
import org.robotui.message.MessageRegistry;
import org.robotui.message.SchemaLookup;
import org.robotui.ros.Eventually;
import org.robotui.ros.Graph;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosNode;

/** An action that we serve, and a client that follows goals as actionlib's do. */
class ActionServerTest {

  private static final Duration TIME = Duration.ofSeconds(20);
  private static final Map<String, ?> GOAL = Map.of("target_pose", Map.of("pose", Map.of("position", Map.of("x", 3))));

  private final MessageRegistry registry = new MessageRegistry(new LocalDefinitions(List.of(), List.of()));
  private final BlockingQueue<GoalTaker.Taken> taken = new LinkedBlockingQueue<>();
  private final AtomicInteger cancelled = new AtomicInteger();
  private final AtomicBoolean ends = new AtomicBoolean();
  private final GoalLog log = new GoalLog();
  private Graph graph;
  private RosNode node;
  private ActionWire wire;
  private ActionServer server;
  private ActionClient client;
  private Thread pulse;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    wire = (ActionWire) assertInstanceOf(SchemaLookup.Found.class,
        ActionWire.find("move_base_msgs/MoveBaseAction", registry)).schema();
    node = graph.node("server");
    server = ActionServer.open(node, GraphName.of("drive"), wire, (goal, from, each) -> {
      assertEquals(3, goal.number("target_pose.pose.position.x").orElse(0));
      taken.add(each);
      return cancelled::incrementAndGet;
    });
    client = ActionClient.open(graph.node("client"), GraphName.of("drive"), wire.type(), registry,
        new ActionOptions(graph.threads(), TIME, 5));
    pulse = Thread.ofVirtual().start(this::tick);
  }

  private void tick() {
    while (!ends.get()) {
      server.tick();
      LockSupport.parkNanos(20_000_000);
    }
  }

  @AfterEach
  void stop() throws InterruptedException {
    ends.set(true);
    pulse.join();
    client.close();
    server.close();
    graph.close();
  }

  private GoalHandle send() {
    return client.send(GOAL, log, TIME).toOptional().orElseThrow();
  }

  private GoalTaker.Taken next() throws InterruptedException {
    return taken.poll(20, TimeUnit.SECONDS);
  }

  private DynamicMessage feedback(double x) throws MessageException {
    return new DynamicCodec(wire.type().feedback())
        .build(Map.of("base_position", Map.of("pose", Map.of("position", Map.of("x", x)))));
  }

  @Test
  void aGoalIsBegunToldOfAndEnds() throws Exception {
    send();
    GoalTaker.Taken goal = next();
    log.awaitPhase(GoalPhase.PENDING);
    goal.begun();
    log.awaitPhase(GoalPhase.ACTIVE);
    goal.feedback(feedback(1.5));
    Eventually.await("feedback", () -> log.feedback.equals(List.of(1.5)));
    goal.end(GoalEnd.SUCCEEDED, "there", Optional.of(new DynamicCodec(wire.type().result()).build(Map.of())));
    goal.end(GoalEnd.ABORTED, "too late", Optional.empty());
    assertEquals("SUCCEEDED there", log.awaitEnd().end() + " " + log.awaitEnd().text());
  }

  @Test
  void aGoalIsRejectedWithAReasonBeforeItIsBegunAndAbortedLater() throws Exception {
    send();
    next().end(GoalEnd.REJECTED, "stopped", Optional.empty());
    assertEquals("REJECTED stopped", log.awaitEnd().end() + " " + log.awaitEnd().text());
    log.outcomes.clear();
    send();
    GoalTaker.Taken late = next();
    late.begun();
    log.awaitPhase(GoalPhase.ACTIVE);
    late.end(GoalEnd.REJECTED, "stopped", Optional.empty());
    assertEquals(GoalEnd.ABORTED, log.awaitEnd().end());
  }

  @Test
  void aGoalIsCancelledOnceAndItsTakerSaysHowItEnds() throws Exception {
    GoalHandle handle = send();
    GoalTaker.Taken goal = next();
    goal.begun();
    log.awaitPhase(GoalPhase.ACTIVE);
    handle.cancel();
    handle.cancel();
    log.awaitPhase(GoalPhase.PREEMPTING);
    Eventually.await("the cancellation", () -> cancelled.get() == 1);
    goal.end(GoalEnd.PREEMPTED, "", Optional.empty());
    assertEquals(GoalEnd.PREEMPTED, log.awaitEnd().end());
    assertEquals(1, cancelled.get());
  }

  @Test
  void aServerThatLeavesAsksForTheEndOfItsGoals() throws Exception {
    send();
    next().begun();
    server.close();
    Eventually.await("the cancellation", () -> cancelled.get() == 1);
  }

  @Test
  void itIsFoundAmongTheActions() {
    assertTrue(client.awaitServer(TIME));
    Eventually.await("the action", () -> Actions.list(node.master()).toOptional().orElseThrow().stream()
        .anyMatch(each -> each.type().equals("move_base_msgs/MoveBaseAction") && each.server().equals("/server")));
  }
}
