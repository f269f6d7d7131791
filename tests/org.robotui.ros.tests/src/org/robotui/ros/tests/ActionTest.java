package org.robotui.ros.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.DynamicMessage;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageRegistry;
import org.robotui.message.SchemaLookup;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosNode;
import org.robotui.ros.action.ActionClient;
import org.robotui.ros.action.ActionInfo;
import org.robotui.ros.action.ActionOptions;
import org.robotui.ros.action.ActionType;
import org.robotui.ros.action.Actions;
import org.robotui.ros.action.GoalEnd;
import org.robotui.ros.action.GoalHandle;
import org.robotui.ros.action.GoalListener;
import org.robotui.ros.action.GoalOutcome;
import org.robotui.ros.action.GoalPhase;

/** Our action client with actionlib's own server, for a type that is known by its definitions only. */
class ActionTest {

  private static final Duration TIME = Duration.ofSeconds(10);
  private static final String STATUS = "Header header\nactionlib_msgs/GoalStatus status\n";
  private static final Map<String, String> DEFINITIONS = Map.of(
      "TestGoal", "int32 goal\n", "TestResult", "int32 result\n", "TestFeedback", "int32 feedback\n",
      "TestActionGoal", "Header header\nactionlib_msgs/GoalID goal_id\nTestGoal goal\n",
      "TestActionResult", STATUS + "TestResult result\n", "TestActionFeedback", STATUS + "TestFeedback feedback\n");

  private final List<GoalPhase> phases = new CopyOnWriteArrayList<>();
  private final List<Double> feedback = new CopyOnWriteArrayList<>();
  private RosWorld world;
  private RosNode node;
  private Peer server;
  private ActionClient client;

  @BeforeEach
  void start() throws Exception {
    RosInstallation.assumeThere();
    RosInstallation.assumePython("actionlib.msg", "python3-actionlib");
    world = new RosWorld();
    world.roscore();
    server = world.python("action_server.py", "counter", "/count");
    node = world.node("client");
    MessageRegistry registry = new MessageRegistry(new LocalDefinitions(List.of(definitions()), List.of()));
    ActionType type = ((SchemaLookup.Found<ActionType>) ActionType.find("actionlib/TestAction", registry)).schema();
    client = ActionClient.open(node, GraphName.of("/count"), type, registry,
        ActionOptions.standard(Thread.ofPlatform().daemon().factory()));
  }

  private Path definitions() throws Exception {
    Path share = world.folder().resolve("share");
    Path messages = Files.createDirectories(share.resolve("actionlib/msg"));
    for (Map.Entry<String, String> each : DEFINITIONS.entrySet()) {
      Files.writeString(messages.resolve(each.getKey() + ".msg"), each.getValue());
    }
    return share;
  }

  @AfterEach
  void stop() throws Exception {
    if (world != null) {
      client.close();
      world.close();
    }
  }

  private GoalHandle send(int goal) {
    Outcome<GoalHandle> outcome = client.send(Map.of("goal", goal), new GoalListener() {
      @Override
      public void onPhase(GoalPhase phase, String text) {
        phases.add(phase);
      }

      @Override
      public void onFeedback(DynamicMessage message) {
        feedback.add(message.number("feedback").orElseThrow());
      }
    }, TIME);
    return outcome.toOptional().orElseThrow(() -> new AssertionError(outcome.reason()));
  }

  private static GoalOutcome end(GoalHandle goal) throws Exception {
    return goal.done().toCompletableFuture().get(TIME.toSeconds(), TimeUnit.SECONDS);
  }

  private void expect(GoalHandle goal, GoalEnd end, String text, double result) throws Exception {
    GoalOutcome outcome = end(goal);
    assertEquals(end, outcome.end(), outcome.toString());
    assertEquals(text, outcome.text());
    assertEquals(result, outcome.result().orElseThrow().number("result").orElseThrow());
  }

  @Test
  void theActionIsListedWithItsTypeAndServer() {
    Eventually.await("the action", () -> Actions.list(node.master()).equals(new Outcome.Done<>(
        List.of(new ActionInfo(GraphName.of("/count"), "actionlib/TestAction", "/counter")))));
  }

  @Test
  void aGoalSucceedsWithFeedbackAndResult() throws Exception {
    expect(send(5), GoalEnd.SUCCEEDED, "counted", 5);
    assertEquals(List.of(0.0, 1.0, 2.0, 3.0, 4.0), feedback);
    assertTrue(phases.containsAll(List.of(GoalPhase.ACTIVE, GoalPhase.WAITING_FOR_RESULT, GoalPhase.DONE)),
        phases.toString());
    expect(send(1), GoalEnd.SUCCEEDED, "counted", 1);
    assertEquals(2, server.lines().stream().filter(line -> line.startsWith("goal ")).count());
  }

  @Test
  void goalsAreAbortedAndRejectedInTheServersWords() throws Exception {
    expect(send(0), GoalEnd.ABORTED, "nothing to count", 7);
    expect(send(-1), GoalEnd.REJECTED, "no negative goals", 0);
  }

  @Test
  void oneOfTwoGoalsIsCancelledWhileTheOtherGoesOn() throws Exception {
    GoalHandle cancelled = send(900);
    GoalHandle other = send(15);
    Eventually.await("feedback", () -> feedback.size() > 4);
    cancelled.cancel();
    GoalOutcome outcome = end(cancelled);
    assertEquals(GoalEnd.PREEMPTED, outcome.end());
    assertTrue(outcome.text().startsWith("stopped at"), outcome.text());
    expect(other, GoalEnd.SUCCEEDED, "counted", 15);
    server.awaitLine("cancel " + cancelled.id());
  }

  @Test
  void aPendingGoalIsRecalled() throws Exception {
    GoalHandle goal = send(2000);
    Eventually.await("pending", () -> goal.phase() == GoalPhase.PENDING);
    goal.cancel();
    expect(goal, GoalEnd.RECALLED, "never begun", 0);
  }

  @Test
  void aServerThatFreezesLosesTheGoal() throws Exception {
    GoalHandle goal = send(900);
    Eventually.await("feedback", () -> feedback.size() > 2);
    server.tell("freeze");
    GoalOutcome outcome = end(goal);
    assertEquals(GoalEnd.LOST, outcome.end());
    assertTrue(outcome.text().contains("/counter said nothing for 5000 ms"), outcome.text());
  }

  @Test
  void aServerThatStartsAnewDoesNotGetTheOldGoal() throws Exception {
    GoalHandle goal = send(900);
    Eventually.await("feedback", () -> feedback.size() > 2);
    server.kill();
    server = world.python("action_server.py", "counter", "/count");
    assertEquals(GoalEnd.LOST, end(goal).end());
    expect(send(3), GoalEnd.SUCCEEDED, "counted", 3);
    assertEquals(List.of("goal 3"), server.lines().stream().filter(line -> line.startsWith("goal "))
        .map(line -> line.substring(0, 6)).toList());
  }
}
