package org.robotui.ros2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.ActionDefinition;
import org.robotui.message.ActionSchema;
import org.robotui.message.DefinitionException;
import org.robotui.message.Definitions;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Generation;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.description.TypeName;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.action.Ros2ActionClient;
import org.robotui.ros2.action.Ros2ActionOptions;
import org.robotui.ros2.action.Ros2ActionServer;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalHandle;
import org.robotui.ros2.action.Ros2GoalListener;
import org.robotui.ros2.action.Ros2GoalOutcome;
import org.robotui.ros2.action.Ros2GoalPhase;
import org.robotui.ros2.action.Ros2GoalTaker;
import org.robotui.ros2.action.Ros2GoalWorker;
import org.robotui.ros2.graph.GraphAction;

/** Goals of one node at another. */
class ActionsTest {

  private static final Duration LONG = Duration.ofSeconds(30);

  private final FakeDomain domain = new FakeDomain();
  private final List<String> heard = new CopyOnWriteArrayList<>();
  private final Ros2GoalListener listener = new Ros2GoalListener() {
    @Override
    public void onPhase(Ros2GoalPhase phase) {
      heard.add(phase.name());
    }

    @Override
    public void onFeedback(DynamicMessage feedback) {
      heard.add("at " + (int) feedback.number("at").orElse(-1));
    }

    @Override
    public void onDone(Ros2GoalOutcome outcome) {
      heard.add(outcome.end().name());
    }
  };

  @AfterEach
  void close() {
    domain.close();
  }

  private static Ros2Types.TypedAction count() throws DefinitionException {
    ActionSchema schema = ActionSchema.resolve(
        ActionDefinition.parse("demo/Count", "int32 to\n---\nint32 reached\n---\nint32 at\n"),
        Definitions.shipped(Generation.ROS2));
    return new Ros2Types.TypedAction(TypeName.parse("demo/action/Count").orElseThrow(), schema);
  }

  /** Counts, and goes on until it is cancelled where there is no end. */
  private static final class Counting implements Ros2GoalWorker {
    @Override
    public boolean accept(DynamicMessage goal) {
      return goal.number("to").orElse(0) >= 0;
    }

    @Override
    public End work(DynamicMessage goal, Running running) throws InterruptedException {
      int to = (int) goal.number("to").orElse(0);
      for (int i = 1; i <= to; i++) {
        running.feedback(Map.of("at", i));
        for (int pause = 0; to > 3 && pause < 20 && !running.cancelled(); pause++) {
          Thread.sleep(5);
        }
        if (running.cancelled()) {
          return new End(Ros2GoalEnd.CANCELED, Map.of("reached", i));
        }
      }
      return new End(Ros2GoalEnd.SUCCEEDED, Map.of("reached", to));
    }
  }

  private Ros2ActionClient open(Ros2Context robot, Duration silence) throws DefinitionException {
    Ros2ActionServer.open(robot.node("counter"), "count", count(), Thread::new, new Counting());
    return Ros2ActionClient.open(domain.context().node("client"), "/count", count(),
        new Ros2ActionOptions(Thread::new, silence, 2));
  }

  private static Ros2GoalOutcome end(Outcome<Ros2GoalHandle> sent) throws Exception {
    return sent.toOptional().orElseThrow(() -> new AssertionError(sent.reason())).done().toCompletableFuture()
        .get(20, TimeUnit.SECONDS);
  }

  @Test
  void aGoalIsReachedWithFeedbackOnTheWay() throws Exception {
    Ros2ActionClient client = open(domain.context(), LONG);
    Ros2GoalOutcome outcome = end(client.send(Map.of("to", 3), listener, LONG));
    assertEquals(Ros2GoalEnd.SUCCEEDED, outcome.end());
    assertEquals(3, outcome.result().orElseThrow().number("reached").orElse(-1));
    assertTrue(heard.containsAll(List.of("DONE", "SUCCEEDED")), heard.toString());
    assertEquals("SUCCEEDED", heard.get(heard.size() - 1));
  }

  @Test
  void aGoalIsCancelled() throws Exception {
    Ros2ActionClient client = open(domain.context(), LONG);
    Outcome<Ros2GoalHandle> sent = client.send(Map.of("to", 1000), listener, LONG);
    Eventually.await("feedback", () -> heard.contains("at 1"));
    Eventually.await("it works", () -> heard.contains("EXECUTING"));
    sent.toOptional().orElseThrow().cancel();
    assertEquals(Ros2GoalEnd.CANCELED, end(sent).end());
    assertTrue(client.cancelAll(LONG));
  }

  @Test
  void whatTheServerDoesNotWantIsRefused() throws Exception {
    Ros2ActionClient client = open(domain.context(), LONG);
    Outcome<Ros2GoalHandle> sent = client.send(Map.of("to", -1), listener, LONG);
    assertEquals("the server of /count did not want the goal", sent.reason());
    assertEquals(List.of("DONE", "REJECTED"), heard);
    assertInstanceOf(Outcome.Refused.class, client.send(Map.of("too", 1), listener, LONG));
  }

  @Test
  void aTakerDecidesAndEndsGoalsLater() throws Exception {
    BlockingQueue<Ros2GoalTaker.Taken> taken = new LinkedBlockingQueue<>();
    CountDownLatch cancelled = new CountDownLatch(1);
    Ros2ActionServer.open(domain.context().node("later"), "later", count(), (goal, each) -> {
      taken.add(each);
      return cancelled::countDown;
    });
    Ros2ActionClient client = Ros2ActionClient.open(domain.context().node("client"), "/later", count(),
        new Ros2ActionOptions(Thread::new, LONG, 2));
    CompletableFuture<Outcome<Ros2GoalHandle>> refused =
        CompletableFuture.supplyAsync(() -> client.send(Map.of("to", 1), listener, LONG));
    taken.poll(20, TimeUnit.SECONDS).end(Ros2GoalEnd.REJECTED, Optional.empty());
    assertInstanceOf(Outcome.Refused.class, refused.get(20, TimeUnit.SECONDS));

    CompletableFuture<Outcome<Ros2GoalHandle>> sent =
        CompletableFuture.supplyAsync(() -> client.send(Map.of("to", 1), listener, LONG));
    Ros2GoalTaker.Taken goal = taken.poll(20, TimeUnit.SECONDS);
    goal.feedback(message(Map.of("at", 7), count().schema().feedback()));
    sent.get(20, TimeUnit.SECONDS).toOptional().orElseThrow().cancel();
    assertTrue(cancelled.await(20, TimeUnit.SECONDS));
    goal.end(Ros2GoalEnd.CANCELED, Optional.of(message(Map.of("reached", 8), count().schema().result())));
    Ros2GoalOutcome outcome = end(sent.join());
    assertEquals(Ros2GoalEnd.CANCELED, outcome.end());
    assertEquals(8, outcome.result().orElseThrow().number("reached").orElse(-1));
  }

  private static DynamicMessage message(Map<String, ?> values, MessageSchema schema) throws MessageException {
    return new DynamicCodec(schema).build(values);
  }

  @Test
  void aGoalWhoseServerIsGoneIsLost() throws Exception {
    Ros2Context robot = domain.context();
    Ros2ActionClient client = open(robot, Duration.ofMillis(200));
    Outcome<Ros2GoalHandle> sent = client.send(Map.of("to", 1000), listener, LONG);
    sent.toOptional().orElseThrow();
    robot.close();
    Ros2GoalOutcome outcome = end(sent);
    assertEquals(Ros2GoalEnd.LOST, outcome.end());
    assertEquals("the server of /count is gone", outcome.text());
    assertInstanceOf(Outcome.TimedOut.class, client.send(Map.of("to", 1), listener, Duration.ofMillis(20)));
  }

  @Test
  void theGraphShowsActionsAsSuch() throws Exception {
    Ros2ActionClient client = open(domain.context(), LONG);
    Ros2Context here = domain.context();
    Eventually.await("the action", () -> here.graph().state().actions().size() == 1);
    GraphAction action = here.graph().state().actions().get(0);
    assertEquals(client.name(), action.name());
    assertEquals("demo/action/Count", action.type().orElseThrow().toString());
    assertEquals(1, action.servers().size());
    assertTrue(here.graph().state().services().isEmpty(), "its services are not listed");
  }
}
