package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.DynamicMessage;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageRegistry;
import org.robotui.message.RecordCodec;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.message.ros.sensor_msgs.JointState;
import org.robotui.message.ros.sensor_msgs.NavSatFix;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.action.ActionClient;
import org.robotui.ros.action.ActionInfo;
import org.robotui.ros.action.ActionOptions;
import org.robotui.ros.action.ActionType;
import org.robotui.ros.action.Actions;
import org.robotui.ros.action.GoalEnd;
import org.robotui.ros.action.GoalHandle;
import org.robotui.ros.action.GoalListener;
import org.robotui.ros.action.GoalOutcome;
import org.robotui.ros.reconfigure.ConfigValue;
import org.robotui.ros.reconfigure.ConfigValues;
import org.robotui.ros.reconfigure.ReconfigureClient;
import org.robotui.ros.reconfigure.ReconfigureListener;
import org.robotui.ros.reconfigure.ReconfigureServers;

/** The action, the tunables and the newer sensors of the demo over loopback. Runs ten times faster than real. */
class DemoServersTest {
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private final BlockingQueue<Double> feedback = new LinkedBlockingQueue<>();
  private Demo demo;
  private RosNode observer;

  @BeforeEach
  void start() throws IOException {
    demo = Demo.start(Options.parse(List.of("--name", "base", "--speed-factor", "10")));
    NodeOptions options = NodeOptions.standard(task -> Thread.ofPlatform().daemon().unstarted(task));
    observer = RosNode.open(RosEnvironment.of(demo.masterUri()), GraphName.of("observer"), options);
  }

  @AfterEach
  void end() {
    observer.close();
    demo.close();
  }

  private ActionClient moveBase() {
    MessageRegistry registry = new MessageRegistry(new LocalDefinitions(List.of(), List.of()));
    ActionType type =
        ActionType.find("move_base_msgs/MoveBaseAction", registry) instanceof SchemaLookup.Found<ActionType> found
            ? found.schema()
            : null;
    return ActionClient.open(observer, GraphName.of("/move_base"), type, registry,
        ActionOptions.standard(Thread.ofPlatform().daemon().factory()));
  }

  private GoalHandle drive(ActionClient client, String frame, double x, double y) {
    GoalListener listener = new GoalListener() {
      @Override
      public void onFeedback(DynamicMessage message) {
        feedback.add(message.number("base_position.pose.position.x").orElseThrow());
      }
    };
    Map<String, ?> pose = Map.of("position", Map.of("x", x, "y", y), "orientation", Map.of("w", 1));
    Outcome<GoalHandle> sent = client
        .send(Map.of("target_pose", Map.of("header", Map.of("frame_id", frame), "pose", pose)), listener, PATIENCE);
    return sent.toOptional().orElseThrow(() -> new AssertionError(sent.reason()));
  }

  private static GoalOutcome end(GoalHandle goal) throws Exception {
    return goal.done().toCompletableFuture().get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
  }

  private <T> T first(String topic, MessageCodec<T> codec) throws InterruptedException {
    BlockingQueue<T> queue = new LinkedBlockingQueue<>();
    try (var subscriber =
        observer.subscriber(topic, codec, SubscriberOptions.standard(), (message, from) -> queue.add(message))) {
      T message = queue.poll(PATIENCE.toNanos(), TimeUnit.NANOSECONDS);
      assertTrue(message != null, subscriber.topic() + " is silent");
      return message;
    }
  }

  @Test
  void aGoalOfTheActionIsReachedWithFeedback() throws Exception {
    try (ActionClient client = moveBase()) {
      GoalOutcome outcome = end(drive(client, "base_link", 1, 0));
      assertEquals(GoalEnd.SUCCEEDED, outcome.end(), outcome.toString());
      assertTrue(feedback.stream().distinct().count() > 2, feedback.toString());
      assertEquals(
          new Outcome.Done<>(
              List.of(new ActionInfo(GraphName.of("/move_base"), "move_base_msgs/MoveBaseAction", "/base"))),
          Actions.list(observer.master()));
    }
  }

  @Test
  void goalsThatCannotBeReachedEndWithTheReason() throws Exception {
    try (ActionClient client = moveBase()) {
      GoalOutcome wall = end(drive(client, "map", 5, 2));
      assertEquals(GoalEnd.ABORTED, wall.end());
      assertTrue(wall.text().startsWith("goal refused: "), wall.text());
      GoalOutcome nowhere = end(drive(client, "moon", 1, 1));
      assertEquals(GoalEnd.REJECTED, nowhere.end());
      assertTrue(nowhere.text().contains("no transform from 'moon'"), nowhere.text());
    }
  }

  @Test
  void aGoalIsCancelledOrReplaced() throws Exception {
    try (ActionClient client = moveBase()) {
      GoalHandle cancelled = drive(client, "map", 12, 5);
      feedback.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS);
      cancelled.cancel();
      assertEquals(new GoalOutcome(GoalEnd.PREEMPTED, "goal cancelled", end(cancelled).result()), end(cancelled));
      GoalHandle replaced = drive(client, "map", 12, 5);
      feedback.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS);
      GoalHandle last = drive(client, "base_link", 0.3, 0);
      assertEquals(GoalEnd.PREEMPTED, end(replaced).end());
      assertEquals(GoalEnd.SUCCEEDED, end(last).end());
    }
  }

  @Test
  void limitsAreTunedWhileItRuns() {
    assertEquals(new Outcome.Done<>(List.of("/base")), ReconfigureServers.list(observer.master()));
    try (ReconfigureClient client =
        ReconfigureClient.open(observer, GraphName.of("/base"), ReconfigureListener.none())) {
      assertTrue(client.await(PATIENCE));
      assertEquals(List.of("Careful", "Normal", "Brisk"),
          client.description().orElseThrow().parameter("driving_style").orElseThrow()
              .choices().stream().map(choice -> choice.name()).toList());
      Outcome<ConfigValues> outcome = client.set(Map.of("max_linear_speed", 99, "driving_style", 2), PATIENCE);
      ConfigValues now =
          assertInstanceOf(Outcome.Done.class, outcome).value() instanceof ConfigValues values ? values : null;
      assertEquals(new ConfigValue.Real(1.5), now.values().get("max_linear_speed"));
      assertEquals(new ConfigValue.Whole(2), now.values().get("driving_style"));
      assertEquals(new XmlRpcValue.Real(1.5),
          observer.parameters().get("/base/max_linear_speed").toOptional().orElseThrow());
    }
  }

  @Test
  void theNewerSensorsAreLive() throws InterruptedException {
    NavSatFix fix = first("/fix", RecordCodec.of(NavSatFix.class));
    assertEquals("gps_link", fix.header().frameId());
    assertEquals(48.2655, fix.latitude(), 1e-3);
    assertEquals(List.of("left_wheel_joint", "right_wheel_joint", "pan_joint", "tilt_joint"),
        first("/joint_states", RecordCodec.of(JointState.class)).name());
    Image depth = first("/camera/depth/image_raw", RecordCodec.of(Image.class));
    assertEquals("16UC1", depth.encoding());
    assertEquals(depth.height() * depth.step(), depth.data().remaining());
  }
}
