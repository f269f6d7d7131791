package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.ActionOffer;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.ServiceGrant;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.message.AnyCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageRegistry;
import org.robotui.message.RecordCodec;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ros.actionlib_msgs.GoalStatusArray;
import org.robotui.ros.GraphName;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.action.ActionClient;
import org.robotui.ros.action.ActionOptions;
import org.robotui.ros.action.ActionType;
import org.robotui.ros.action.GoalHandle;
import org.robotui.ros.action.GoalListener;
import org.robotui.ros.action.GoalOutcome;
import org.robotui.ros.action.GoalPhase;

/** Actions for nodes of the robot that are carried out outside of it. */
class RosServeActionTest extends RosRficCase {
  private static final FieldPath X = FieldPath.parse("target_pose.pose.position.x");

  private final MessageRegistry registry = new MessageRegistry(new LocalDefinitions(List.of(), List.of()));
  private final List<Double> feedback = new CopyOnWriteArrayList<>();
  private final List<GoalPhase> phases = new CopyOnWriteArrayList<>();

  /** A goal to x = 1 is reached at once, one to 2 refused, and others go on until they are cancelled. */
  private static final class Work implements Call<ActionReply> {
    private final CompletableFuture<CallOutcome<ActionReply>> outcome = new CompletableFuture<>();

    static Call<ActionReply> begin(DynamicRecord goal, Progress progress) {
      Work work = new Work();
      double x = ((FieldValue.Num) goal.at(X).orElseThrow()).value();
      if (x == 2) {
        work.outcome.complete(new CallOutcome.Failed<>("the robot is stopped"));
        return work;
      }
      progress.at(Double.NaN, "active");
      progress.feedback(new MapRecord("far", Map.of("base_position", goal.field("target_pose").orElseThrow())));
      if (x == 1) {
        work.end(ActionReply.End.SUCCEEDED, "there");
      }
      return work;
    }

    private void end(ActionReply.End how, String text) {
      outcome.complete(
          new CallOutcome.Replied<>(new ActionReply(how, text, Optional.of(new MapRecord("far", Map.of())))));
    }

    @Override
    public CompletionStage<CallOutcome<ActionReply>> outcome() {
      return outcome;
    }

    @Override
    public void cancel() {
      end(ActionReply.End.PREEMPTED, "as asked");
    }
  }

  /** Offers go on until they are not made again, however slow the machine is. */
  private Thread renewing(ActionOffer offer) {
    return Thread.ofVirtual().start(() -> {
      while (!Thread.currentThread().isInterrupted()) {
        try {
          call("serve_action", offer);
          Thread.sleep(Duration.ofSeconds(1));
        } catch (CallException | InterruptedException e) {
          Thread.currentThread().interrupt();
        }
      }
    });
  }

  private ActionClient client() {
    ActionType type = (ActionType) assertInstanceOf(SchemaLookup.Found.class,
        ActionType.find("move_base_msgs/MoveBaseAction", registry)).schema();
    return ActionClient.open(robot, GraphName.of("/far/drive"), type, registry,
        new ActionOptions(DAEMONS, PATIENCE, 5));
  }

  private GoalHandle send(ActionClient client, double x) {
    return client.send(Map.of("target_pose", Map.of("pose", Map.of("position", Map.of("x", x)))), new GoalListener() {
      @Override
      public void onPhase(GoalPhase phase, String text) {
        phases.add(phase);
      }

      @Override
      public void onFeedback(DynamicMessage message) {
        feedback.add(message.number("base_position.pose.position.x").orElse(-1));
      }
    }, PATIENCE).toOptional().orElseThrow();
  }

  private static String end(GoalHandle goal) throws Exception {
    GoalOutcome outcome = goal.done().toCompletableFuture().get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    return outcome.end() + ": " + outcome.text();
  }

  @Test
  void aNodeSendsGoalsToWhatIsOffered() throws Exception {
    rfic.start();
    ActionOffer offer = new ActionOffer("far/drive", "move_base_msgs/MoveBase", (goal, who, told) -> Work.begin(goal,
        told));
    assertEquals(new ServiceGrant("/far/drive", "move_base_msgs/MoveBaseAction"), call("serve_action", offer));
    Thread renewing = renewing(offer);
    try (ActionClient client = client()) {
      assertEquals("SUCCEEDED: there", end(send(client, 1)));
      assertEquals("REJECTED: the robot is stopped", end(send(client, 2)));
      GoalHandle far = send(client, 3);
      await(() -> feedback.contains(3.0));
      far.cancel();
      assertEquals("PREEMPTED: as asked", end(far));
      assertTrue(phases.contains(GoalPhase.DONE), phases.toString());
    } finally {
      renewing.interrupt();
    }
  }

  @Test
  void whatIsServedAlreadyOrUnknownIsNotOffered() {
    rfic.start();
    await(() -> refusal("demo/Unknown").contains("demo/Unknown"));
    robot.publisher("/far/drive/status", RecordCodec.of(
        GoalStatusArray.class), PublisherOptions.standard());
    robot.subscriber("/far/drive/goal", new AnyCodec(registry),
        SubscriberOptions.standard(), (message, from) -> {});
    await(() -> refusal("move_base_msgs/MoveBase").contains("/far/drive is served already, by /robot"));
  }

  private String refusal(String type) {
    try {
      call("serve_action", new ActionOffer("far/drive", type, (goal, who, told) -> Work.begin(goal, told)));
      return "";
    } catch (CallException e) {
      return e.getMessage();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }
}
