package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
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
import org.robotui.message.ActionSchema;
import org.robotui.message.DynamicMessage;
import org.robotui.message.SchemaLookup;
import org.robotui.message.description.TypeName;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.action.Ros2ActionClient;
import org.robotui.ros2.action.Ros2ActionOptions;
import org.robotui.ros2.action.Ros2GoalHandle;
import org.robotui.ros2.action.Ros2GoalListener;

/** Actions for nodes of the robot that are carried out outside of it. */
class Ros2ServeActionTest extends Ros2Case {
  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final TypeName TYPE = TypeName.parse("nav2_msgs/action/NavigateToPose").orElseThrow();
  private static final FieldPath X = FieldPath.parse("pose.pose.position.x");

  private final BlockingQueue<Goal> goals = new LinkedBlockingQueue<>();
  private final List<Double> feedback = new CopyOnWriteArrayList<>();

  private record Goal(DynamicRecord asked, Progress progress, CompletableFuture<CallOutcome<ActionReply>> outcome)
      implements Call<ActionReply> {
    @Override
    public void cancel() {
      end(ActionReply.End.PREEMPTED);
    }

    void end(ActionReply.End how) {
      outcome.complete(new CallOutcome.Replied<>(new ActionReply(how, "", Optional.of(
          new MapRecord("far", Map.of("error_code", new FieldValue.Num(9003, "9003")))))));
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

  private Call<ActionReply> begin(DynamicRecord asked, String client, Progress progress) {
    Goal goal = new Goal(asked, progress, new CompletableFuture<>());
    goals.add(goal);
    return goal;
  }

  private CompletableFuture<Outcome<Ros2GoalHandle>> send(Ros2ActionClient client) {
    return CompletableFuture.supplyAsync(
        () -> client.send(Map.of("pose", Map.of("pose", Map.of("position", Map.of("x", 3)))), new Ros2GoalListener() {
          @Override
          public void onFeedback(DynamicMessage message) {
            feedback.add(message.number("distance_remaining").orElse(-1));
          }
        }, PATIENCE));
  }

  private Goal next() throws InterruptedException {
    return goals.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS);
  }

  private static String end(CompletableFuture<Outcome<Ros2GoalHandle>> sent) throws Exception {
    return sent.get(PATIENCE.toSeconds(), TimeUnit.SECONDS).toOptional().orElseThrow().done()
        .thenApply(outcome -> outcome.end() + " "
            + outcome.result().map(result -> result.number("error_code").orElse(-1)).orElse(-2.0))
        .toCompletableFuture().get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
  }

  @Test
  void aNodeSendsGoalsToWhatIsOffered() throws Exception {
    rfic.start();
    ActionOffer offer = new ActionOffer("far/drive", "nav2_msgs/NavigateToPoseAction", this::begin);
    assertEquals(new ServiceGrant("/far/drive", "nav2_msgs/NavigateToPose"), call("serve_action", offer));
    Thread renewing = renewing(offer);
    TypedAction type = new TypedAction(TYPE, (ActionSchema) assertInstanceOf(SchemaLookup.Found.class,
        robot.context().types().registry().action(TYPE, Optional.empty())).schema());
    try (Ros2ActionClient client =
        Ros2ActionClient.open(robot, "far/drive", type, Ros2ActionOptions.standard(Thread::new))) {
      CompletableFuture<Outcome<Ros2GoalHandle>> refused = send(client);
      next().outcome().complete(new CallOutcome.Failed<>("the robot is stopped"));
      assertInstanceOf(Outcome.Refused.class, refused.get(PATIENCE.toSeconds(), TimeUnit.SECONDS));

      CompletableFuture<Outcome<Ros2GoalHandle>> refusedByACode = send(client);
      next().end(ActionReply.End.REJECTED);
      assertEquals("ABORTED 9003.0", end(refusedByACode), "a rejection has no result");

      CompletableFuture<Outcome<Ros2GoalHandle>> reached = send(client);
      Goal goal = next();
      assertEquals(Optional.of(3.0), goal.asked().at(X).map(x -> ((FieldValue.Num) x).value()));
      goal.progress().at(Double.NaN, "active");
      goal.progress().feedback(
          new MapRecord("far", Map.of("distance_remaining", new FieldValue.Num(1.5, "1.5"))));
      await(() -> feedback.contains(1.5));
      goal.end(ActionReply.End.SUCCEEDED);
      assertEquals("SUCCEEDED 9003.0", end(reached));

      CompletableFuture<Outcome<Ros2GoalHandle>> cancelled = send(client);
      next().progress().at(Double.NaN, "executing");
      cancelled.get(PATIENCE.toSeconds(), TimeUnit.SECONDS).toOptional().orElseThrow().cancel();
      assertEquals("CANCELED 9003.0", end(cancelled));
    } finally {
      renewing.interrupt();
    }
  }
}
