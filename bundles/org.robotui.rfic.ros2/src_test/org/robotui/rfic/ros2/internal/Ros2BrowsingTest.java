package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.Browser;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.Browser.Tunable;
import org.robotui.api.port.CallException;
import org.robotui.data.record.FieldValue;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ActionSchema;
import org.robotui.message.description.TypeName;
import org.robotui.message.description.TypeRegistry;
import org.robotui.message.ros.std_msgs.StdFloat64;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.action.Ros2ActionServer;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalWorker;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor;
import org.robotui.ros2.parameter.Ros2ParameterServer;
import org.robotui.ros2.parameter.Ros2ParameterValue;

/** What is asked of the robot: its graph, its parameters, its actions. */
class Ros2BrowsingTest extends Ros2Case {
  private Browser browser() {
    rfic.start();
    await(() -> context.browsers.containsKey("graph"));
    return context.browsers.get("graph");
  }

  private static boolean has(Browser browser, Kind kind, String name) {
    try {
      return browser.list(kind).stream().anyMatch(item -> item.name().equals(name));
    } catch (CallException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void showsTheGraphWithTheQualityOfEachEndAndWhyTwoDoNotMeet() throws Exception {
    robot.publisher("value", Ros2Codec.of(StdFloat64.class), QosProfiles.SENSOR_DATA);
    node("display").subscriber("value", Ros2Codec.of(StdFloat64.class),
        Ros2SubscriberOptions.of(QosProfiles.DEFAULT), (v, from) -> {});
    Browser browser = browser();
    Item value = new Item(Kind.TOPIC, "/value", "std_msgs/Float64");
    await(() -> has(browser, Kind.NODE, "/robot") && has(browser, Kind.NODE, "/display"));
    assertTrue(browser.list(Kind.TOPIC).contains(value));
    assertTrue(browser.links().containsAll(List.of(new Browser.Link("/robot", "/value", true),
        new Browser.Link("/display", "/value", false))), () -> "links");
    Map<String, String> facts = browser.describe(value).facts();
    assertEquals("std_msgs/msg/Float64", facts.get("type"));
    assertEquals("/robot", facts.get("publishers"));
    assertEquals("best effort, volatile, keeps the last 5", facts.get("/robot offers"));
    assertEquals("/display does not hear /robot: the writer offers best effort, the reader asks for reliable",
        facts.get("mismatch"));
    assertTrue(browser.describe(value).shape().orElseThrow().field("data").isPresent());
    assertEquals("/value", browser.describe(new Item(Kind.NODE, "/robot", "")).facts().get("publishes"));
  }

  @Test
  void readsAndSetsParametersOfAllKinds() throws Exception {
    Ros2ParameterServer server = Ros2ParameterServer.open(robot);
    Ros2ParameterValue speed = new Ros2ParameterValue.OfDouble(1);
    server.declare(Ros2ParameterDescriptor.of("limits.speed", speed, "m/s")
        .within(new Ros2ParameterDescriptor.DoubleRange(0, 2, 0.5)), speed, value -> Optional.empty());
    declare(server, "gains", new Ros2ParameterValue.OfDoubles(List.of(1.0, 2.0)));
    declare(server, "frame", new Ros2ParameterValue.OfText("odom"));
    declare(server, "count", new Ros2ParameterValue.OfInteger(3));
    Browser browser = browser();
    await(() -> has(browser, Kind.TUNABLE, "/robot"));
    assertEquals(List.of("/robot/count", "/robot/frame", "/robot/gains", "/robot/limits.speed"),
        browser.list(Kind.PARAMETER).stream().map(Item::name).toList());
    assertEquals(Optional.of(List.of(1.0, 2.0)), browser.parameter("/robot/gains"));
    browser.setParameter("/robot/gains", List.of(3L, 4.5));
    assertEquals(new Ros2ParameterValue.OfDoubles(List.of(3.0, 4.5)), server.value("gains"));
    Map<String, String> facts = browser.describe(new Item(Kind.PARAMETER, "/robot/limits.speed", "")).facts();
    assertEquals("0.0 to 2.0 in steps of 0.5", facts.get("range"));
    Item node = new Item(Kind.TUNABLE, "/robot", "");
    Tunable tunable = browser.tunables(node).stream().filter(t -> t.name().equals("limits.speed")).findFirst()
        .orElseThrow();
    assertEquals(List.of("limits", 1.0, Optional.of(0.0), Optional.of(2.0)),
        List.of(tunable.group(), tunable.value(), tunable.least(), tunable.most()));
    assertEquals(3, browser.tunables(node).size(), "lists are no matter of a form");
    browser.setTunables(node, Map.of("limits.speed", 1.5, "count", 4L));
    assertEquals(new Ros2ParameterValue.OfDouble(1.5), server.value("limits.speed"));
    CallException refused =
        assertThrows(CallException.class, () -> browser.setTunables(node, Map.of("limits.speed", 9.0)));
    assertTrue(refused.getMessage().contains("0.0 to 2.0"), refused.getMessage());
    CallException unlike = assertThrows(CallException.class, () -> browser.setParameter("/robot/count", "many"));
    assertEquals("count holds a number, not many", unlike.getMessage());
    server.close();
  }

  private static void declare(Ros2ParameterServer server, String name, Ros2ParameterValue value) {
    server.declare(Ros2ParameterDescriptor.of(name, value, ""), value, v -> Optional.empty());
  }

  private static TypedAction navigation() {
    TypeName name = TypeName.parse("nav2_msgs/action/NavigateToPose").orElseThrow();
    TypeRegistry shipped = new TypeRegistry(new LocalDefinitions(List.of(), List.of(), Generation.ROS2));
    return new TypedAction(name, ((SchemaLookup.Found<ActionSchema>) shipped.action(name, Optional.empty())).schema());
  }

  /** Goes until it is cancelled, or at once where the goal lies at zero. */
  private static final class Navigating implements Ros2GoalWorker {
    @Override
    public End work(DynamicMessage goal, Running running) throws InterruptedException {
      boolean far = goal.number("pose.pose.position.x").orElse(0) > 0;
      running.feedback(Map.of("distance_remaining", 1.5));
      while (far && !running.cancelled()) {
        Thread.sleep(5);
      }
      return new End(far ? Ros2GoalEnd.CANCELED : Ros2GoalEnd.SUCCEEDED, Map.of());
    }
  }

  @Test
  void sendsGoalsFollowsThemAndCancelsThem() throws Exception {
    Ros2ActionServer server =
        Ros2ActionServer.open(robot, "navigate_to_pose", navigation(), DAEMONS, new Navigating());
    Browser browser = browser();
    await(() -> has(browser, Kind.ACTION, "/navigate_to_pose"));
    Item action = browser.list(Kind.ACTION).getFirst();
    assertEquals("nav2_msgs/NavigateToPose", action.type());
    assertTrue(browser.describe(action).shape().orElseThrow().field("pose").isPresent());
    List<FieldValue> left = new CopyOnWriteArrayList<>();
    ActionReply near = call("actions", new ActionRequest("/navigate_to_pose", Map.of()),
        feedback -> left.add(feedback.field("distance_remaining").orElseThrow()));
    assertEquals(ActionReply.End.SUCCEEDED, near.end());
    assertEquals(List.of(new FieldValue.Num(1.5, "1.5")), left);
    Map<String, Object> far = Map.of("pose", Map.of("pose", Map.of("position", Map.of("x", 1.0))));
    // the call is over after three seconds, which cancels its goal
    ActionReply cancelled = call("actions", new ActionRequest("/navigate_to_pose", far));
    assertEquals(ActionReply.End.PREEMPTED, cancelled.end());
    server.close();
  }
}
