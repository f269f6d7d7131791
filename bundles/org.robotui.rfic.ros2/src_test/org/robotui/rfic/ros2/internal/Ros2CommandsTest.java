package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentLinkedDeque;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.FrameId;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.record.FieldValue;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.TwistStamped;
import org.robotui.message.ros.std_msgs.StdFloat64;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.rtps.Durability;

/** What goes to the robot: commands, single messages, calls of services. */
class Ros2CommandsTest extends Ros2Case {
  private <M extends Record> Deque<M> heardOn(String topic, Class<M> type) {
    Deque<M> heard = new ConcurrentLinkedDeque<>();
    robot.subscriber(topic, Ros2Codec.of(type), Ros2SubscriberOptions.of(QosProfiles.DEFAULT),
        (m, from) -> heard.add(m));
    return heard;
  }

  @Test
  void commandsBothKindsOfVelocity() {
    Deque<Twist> plain = heardOn("cmd_vel", Twist.class);
    Deque<TwistStamped> stamped = heardOn("base/cmd_vel", TwistStamped.class);
    rfic.start();
    await(() -> context.commands.containsKey("cmd_vel") && context.commands.containsKey("base/cmd_vel"));
    assertTrue(context.commands.get("base/cmd_vel").isMotion());
    await(() -> send("cmd_vel", VelocityCommand.planar(0.25, -0.5)) instanceof Sent.Out);
    await(() -> send("base/cmd_vel", VelocityCommand.planar(0.5, 0)) instanceof Sent.Out);
    await(() -> !plain.isEmpty() && !stamped.isEmpty());
    assertEquals(-0.5, plain.getFirst().angular().z());
    assertEquals(0.5, stamped.getFirst().twist().linear().x());
    assertTrue(stamped.getFirst().header().stamp() > 1_600_000_000_000_000_000L, "it says when it was commanded");
  }

  @Test
  void sendsGoalsToTheTopicOfTheNavigation() {
    Deque<PoseStamped> goals = heardOn("goal_pose", PoseStamped.class);
    rfic.start();
    await(() -> context.commands.containsKey("goal_pose"));
    await(() -> send("goal_pose",
        new NavigationGoal(new FrameId("robby", "map"), RigidTransform.planar(1, 2, 0))) instanceof Sent.Out);
    await(() -> !goals.isEmpty());
    assertEquals("map", goals.getFirst().header().frameId());
    assertEquals(2, goals.getFirst().pose().position().y());
  }

  @Test
  void saysWhyNobodyHearsACommand() {
    robot.subscriber("cmd_vel", Ros2Codec.of(Twist.class),
        Ros2SubscriberOptions.of(QosProfiles.DEFAULT.with(Durability.TRANSIENT_LOCAL)), (t, from) -> {});
    rfic(context, Map.of("velocity", List.of("drive"))).start();
    await(() -> context.commands.containsKey("cmd_vel") && context.commands.containsKey("drive"));
    assertEquals("nobody subscribes to /drive now",
        assertInstanceOf(Sent.Refused.class, send("drive", VelocityCommand.ZERO)).reason());
    await(() -> send("cmd_vel", VelocityCommand.ZERO) instanceof Sent.Refused refused && refused.reason()
        .equals("nobody hears /cmd_vel: /robot: the writer offers volatile, the reader asks for transient local"));
  }

  @Test
  void saysAMessageOnceAndNeverOnTopicsThatMoveTheRobot() {
    Deque<StdFloat64> gains = heardOn("gain", StdFloat64.class);
    heardOn("cmd_vel", Twist.class);
    rfic.start();
    await(() -> context.commands.containsKey("cmd_vel"));
    await(() -> say("/gain", "std_msgs/Float64", Map.of("data", 2.5)) instanceof Sent.Out);
    await(() -> gains.size() == 1);
    assertEquals(2.5, gains.getFirst().data());
    Sent moving = say("/cmd_vel", "geometry_msgs/Twist", Map.of());
    assertTrue(assertInstanceOf(Sent.Refused.class, moving).reason().contains("moves the robot"));
  }

  private Sent say(String topic, String type, Map<String, Object> fields) {
    return send("publish", new MessageCommand(topic, type, fields));
  }

  @Test
  void callsServicesByNameAndSaysWhyNot() throws Exception {
    robot.serviceServer("motors", Ros2ServiceCodec.of("std_srvs/srv/SetBool", SetBoolRequest.class,
        SetBoolResponse.class), (request, caller) -> new SetBoolResponse(request.data(), "done"));
    rfic.start();
    await(() -> graphHas("/motors"));
    ServiceReply reply = call("services", new ServiceRequest("/motors", Map.of("data", true)));
    assertEquals(new FieldValue.Flag(true), reply.value().field("success").orElseThrow());
    CallException wrong = assertThrows(CallException.class,
        () -> call("services", new ServiceRequest("/motors", Map.of("dta", true))));
    assertTrue(wrong.getMessage().contains("dta"), wrong.getMessage());
    CallException none = assertThrows(CallException.class,
        () -> call("services", new ServiceRequest("/nowhere", Map.of())));
    assertEquals("nobody offers the service /nowhere", none.getMessage());
    assertFalse(graphHas("/nowhere"));
  }

  private boolean graphHas(String service) {
    try {
      return context.browsers.containsKey("graph") && context.browsers.get("graph")
          .list(Browser.Kind.SERVICE).stream().anyMatch(s -> s.name().equals(service));
    } catch (CallException e) {
      throw new AssertionError(e);
    }
  }
}
