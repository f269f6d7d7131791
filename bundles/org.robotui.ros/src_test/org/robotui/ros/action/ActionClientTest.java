package org.robotui.ros.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageRegistry;
import org.robotui.message.RecordCodec;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.message.ros.actionlib_msgs.GoalStatusArray;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.net.call.Outcome;
import org.robotui.ros.Eventually;
import org.robotui.ros.Graph;
import org.robotui.ros.GraphName;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.testkit.Effort;

/** Goals at a server that does what a test wants. */
class ActionClientTest {

  private static final Duration TIME = Duration.ofSeconds(30);
  private static final Map<String, ?> GOAL = Map.of("target_pose", Map.of("pose", Map.of("position", Map.of("x", 3))));

  private final MessageRegistry registry = new MessageRegistry(new LocalDefinitions(List.of(), List.of()));
  private final GoalLog log = new GoalLog();
  private Graph graph;
  private RosNode serverNode;
  private ScriptedServer server;
  private ActionClient client;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    serverNode = graph.node("server");
    server = new ScriptedServer(serverNode);
    client = open(Duration.ofSeconds(3), 2);
  }

  @AfterEach
  void stop() {
    client.close();
    graph.close();
  }

  private ActionClient open(Duration silence, int goals) throws Exception {
    ActionType type =
        assertInstanceOf(SchemaLookup.Found.class, ActionType.find("move_base_msgs/MoveBaseAction", registry))
            .schema() instanceof ActionType found ? found : null;
    return ActionClient.open(graph.node("client_of_" + goals + "_in_" + silence.toMillis()), GraphName.of("drive"),
        type, registry,
        new ActionOptions(graph.threads(), silence, goals));
  }

  private GoalHandle send() {
    return client.send(GOAL, log, TIME).toOptional().orElseThrow();
  }

  private GoalHandle sendAndReport(int status) {
    GoalHandle goal = send();
    Eventually.await("the goal", () -> server.goals.size() == 1);
    server.report(ScriptedServer.about(goal.id(), status, ""));
    return goal;
  }

  @Test
  void theActionIsFoundByItsTopics() {
    assertTrue(client.awaitServer(TIME));
    assertEquals(
        new Outcome.Done<>(List.of(new ActionInfo(GraphName.of("/drive"), "move_base_msgs/MoveBaseAction", "/server"))),
        Actions.list(serverNode.master()));
  }

  @Test
  void aGoalGoesThroughItsPhasesToItsResult() {
    GoalHandle goal = sendAndReport(GoalStatus.PENDING);
    assertEquals(3, server.goals.get(0).goal().targetPose().pose().position().x());
    assertEquals(goal.id(), server.goals.get(0).goalId().id());
    log.awaitPhase(GoalPhase.PENDING);
    server.report(ScriptedServer.about("another", GoalStatus.ABORTED, ""),
        ScriptedServer.about(goal.id(), GoalStatus.ACTIVE, ""));
    log.awaitPhase(GoalPhase.ACTIVE);
    server.feedback("another", 1);
    server.feedback(goal.id(), 2.5);
    Eventually.await("feedback", () -> log.feedback.equals(List.of(2.5)));
    server.result("another", GoalStatus.ABORTED, "not ours");
    server.result(goal.id(), GoalStatus.SUCCEEDED, "there");
    GoalOutcome outcome = log.awaitEnd();
    assertEquals(GoalEnd.SUCCEEDED, outcome.end());
    assertEquals("there", outcome.text());
    assertEquals("move_base_msgs/MoveBaseResult", outcome.result().orElseThrow().type());
    assertEquals(List.of(GoalPhase.PENDING, GoalPhase.ACTIVE, GoalPhase.WAITING_FOR_RESULT, GoalPhase.DONE),
        log.phases);
    assertEquals(outcome, goal.done().toCompletableFuture().join());
  }

  @Test
  void oneGoalIsCancelledAndTheServerDecidesHowItEnds() {
    GoalHandle goal = sendAndReport(GoalStatus.ACTIVE);
    log.awaitPhase(GoalPhase.ACTIVE);
    goal.cancel();
    Eventually.await("the cancellation", () -> server.cancelled.size() == 1);
    assertEquals(goal.id(), server.cancelled.get(0).id());
    server.report(ScriptedServer.about(goal.id(), GoalStatus.PREEMPTING, ""));
    log.awaitPhase(GoalPhase.PREEMPTING);
    server.result(goal.id(), GoalStatus.PREEMPTED, "as asked");
    assertEquals(GoalEnd.PREEMPTED, log.awaitEnd().end());
    assertEquals(
        List.of(GoalPhase.ACTIVE, GoalPhase.WAITING_FOR_CANCEL, GoalPhase.PREEMPTING, GoalPhase.WAITING_FOR_RESULT,
            GoalPhase.DONE),
        log.phases);
  }

  @Test
  void aCancellationBeforeTheServerBeganRecallsTheGoal() {
    GoalHandle goal = sendAndReport(GoalStatus.PENDING);
    log.awaitPhase(GoalPhase.PENDING);
    goal.cancel();
    server.report(ScriptedServer.about(goal.id(), GoalStatus.RECALLING, ""));
    log.awaitPhase(GoalPhase.RECALLING);
    server.result(goal.id(), GoalStatus.RECALLED, "");
    assertEquals(GoalEnd.RECALLED, log.awaitEnd().end());
  }

  @Test
  void statusesFromBeforeTheGoalDoNotLoseIt() {
    GoalHandle goal = send();
    goal.cancel();
    server.report();
    server.report(ScriptedServer.about(goal.id(), GoalStatus.ACTIVE, ""));
    server.result(goal.id(), GoalStatus.REJECTED, "no");
    assertEquals(GoalEnd.REJECTED, log.awaitEnd().end());
  }

  @Test
  void aServerThatForgetsTheGoalLosesIt() {
    sendAndReport(GoalStatus.ACTIVE);
    log.awaitPhase(GoalPhase.ACTIVE);
    server.report();
    GoalOutcome outcome = log.awaitEnd();
    assertEquals(GoalEnd.LOST, outcome.end());
    assertTrue(outcome.text().contains("/server does not know the goal"), outcome.text());
  }

  @Test
  void aSilentServerLosesTheGoalAndSaysWhy() throws Exception {
    client.close();
    client = open(Duration.ofMillis(300), 2);
    sendAndReport(GoalStatus.ACTIVE);
    GoalOutcome outcome = log.awaitEnd();
    assertEquals(GoalEnd.LOST, outcome.end());
    assertTrue(outcome.text().contains("/server said nothing for 300 ms"), outcome.text());
  }

  @Test
  void aResultThatNeverComesEndsTheGoalAsTheStatusSaid() throws Exception {
    client.close();
    client = open(Duration.ofMillis(300), 2);
    GoalHandle goal = sendAndReport(GoalStatus.SUCCEEDED);
    Eventually.await("the end", () -> {
      server.report(ScriptedServer.about(goal.id(), GoalStatus.SUCCEEDED, ""));
      return !log.outcomes.isEmpty();
    });
    assertEquals(new GoalOutcome(GoalEnd.SUCCEEDED, "", java.util.Optional.empty()), log.outcomes.get(0));
  }

  @Test
  void aGoalTheServerNeverMentionsIsLost() throws Exception {
    client.close();
    client = open(Duration.ofMillis(300), 2);
    send();
    Eventually.await("the end", () -> {
      server.report();
      return !log.outcomes.isEmpty();
    });
    assertTrue(log.outcomes.get(0).text().contains("did not acknowledge"), log.outcomes.toString());
  }

  @Test
  void nothingIsSentWithoutAServerOrAfterTheTimeForIt() throws Exception {
    serverNode.close();
    Outcome<GoalHandle> outcome = client.send(GOAL, log, Duration.ofMillis(200));
    assertInstanceOf(Outcome.TimedOut.class, outcome);
    assertTrue(outcome.reason().contains("/drive has no server"), outcome.reason());
    ScriptedServer late = new ScriptedServer(graph.node("late"));
    assertTrue(client.awaitServer(TIME));
    GoalHandle second = send();
    Eventually.await("the second goal", () -> !late.goals.isEmpty());
    assertEquals(List.of(second.id()), late.goals.stream().map(goal -> goal.goalId().id()).toList());
  }

  @Test
  void goalsThatDoNotFitOrAreTooManyAreRefused() {
    Outcome<GoalHandle> wrong = client.send(Map.of("target", 3), log, TIME);
    assertInstanceOf(Outcome.Refused.class, wrong);
    assertTrue(wrong.reason().contains("target"), wrong.reason());
    send();
    send();
    assertInstanceOf(Outcome.Refused.class, client.send(GOAL, log, TIME));
  }

  @Test
  void allGoalsOfTheClientAreCancelledAndAwaited() {
    GoalHandle goal = sendAndReport(GoalStatus.ACTIVE);
    assertEquals(false, client.cancelAll(Duration.ofMillis(50)));
    server.result(goal.id(), GoalStatus.PREEMPTED, "");
    assertTrue(client.cancelAll(TIME));
  }

  @Test
  void aClosedClientLosesItsGoalsAndLeavesNoThread() {
    send();
    client.close();
    assertEquals("the client was closed", log.awaitEnd().text());
    Eventually.await("no thread", () -> graph.threads().alive().stream().noneMatch(name -> name.startsWith("action ")));
    assertInstanceOf(Outcome.Failed.class, client.send(GOAL, log, TIME));
  }

  @Test
  void whatOthersSayAboutOurGoalIsNotBelieved() throws Exception {
    GoalHandle goal = sendAndReport(GoalStatus.ACTIVE);
    log.awaitPhase(GoalPhase.ACTIVE);
    ScriptedServer stranger = new ScriptedServer(graph.node("stranger"));
    Eventually.await("the stranger", () -> {
      stranger.report();
      stranger.result(goal.id(), GoalStatus.ABORTED, "says the stranger");
      server.feedback(goal.id(), 1);
      return log.feedback.size() > 20;
    });
    assertEquals(List.of(), log.outcomes);
    server.result(goal.id(), GoalStatus.SUCCEEDED, "");
    assertEquals(GoalEnd.SUCCEEDED, log.awaitEnd().end());
  }

  @Test
  void resultsAndFeedbackOfAnotherTypeAreIgnored() throws Exception {
    GoalHandle goal = sendAndReport(GoalStatus.ACTIVE);
    RosNode liar = graph.node("liar");
    Publisher<StdString> result =
        liar.publisher("/drive/result", RecordCodec.of(StdString.class), PublisherOptions.latched());
    Publisher<GoalStatusArray> feedback =
        liar.publisher("/drive/feedback", RecordCodec.of(GoalStatusArray.class), PublisherOptions.latched());
    result.publish(new StdString(goal.id()));
    feedback.publish(new GoalStatusArray(ScriptedServer.HEADER, List.of(ScriptedServer.about(goal.id(), 3, ""))));
    Eventually.await("the liar's links", () -> result.numSubscribers() == 1 && feedback.numSubscribers() == 1);
    server.result(goal.id(), GoalStatus.SUCCEEDED, "");
    assertEquals(GoalEnd.SUCCEEDED, log.awaitEnd().end());
    assertEquals(List.of(), log.feedback);
  }

  @Test
  void anyOrderOfStatusesAndResultsEndsEachGoalOnce() {
    SplittableRandom random = new SplittableRandom(2026);
    for (int round = 0; round < Effort.rounds(300); round++) {
      GoalLog heard = new GoalLog();
      TrackedGoal goal = new TrackedGoal("g", "/server", heard, id -> {}, ended -> {});
      for (int step = 0; step < 12; step++) {
        disturb(goal, random);
      }
      goal.lose("over");
      assertEquals(1, heard.outcomes.size());
      assertEquals(1, heard.phases.stream().filter(GoalPhase.DONE::equals).count());
      assertEquals(GoalPhase.DONE, heard.phases.get(heard.phases.size() - 1));
    }
  }

  private static void disturb(TrackedGoal goal, SplittableRandom random) {
    int code = random.nextInt(-1, 12);
    switch (random.nextInt(8)) {
      case 0 -> goal.cancel();
      case 1 -> goal.statuses(List.of(ScriptedServer.about("other", code, "")));
      case 2 -> goal.result(code, "words", java.util.Optional.empty());
      case 3 -> goal.expire(Duration.ZERO);
      default -> goal.statuses(List.of(ScriptedServer.about("g", code, "x"), ScriptedServer.about("g", 3, "twice")));
    }
  }
}
