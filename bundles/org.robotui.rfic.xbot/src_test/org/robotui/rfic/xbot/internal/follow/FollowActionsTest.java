package org.robotui.rfic.xbot.internal.follow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;

class FollowActionsTest {
  private static final String ACTION = "Arm/follow_joint_trajectory";
  private static final Map<String, Object> POINT =
      Map.of("positions", List.of(0.5, 1L), "velocities", List.of(), "time_from_start", 1_500_000_000L);
  private static final Map<String, Object> WAY =
      Map.of("joint_names", List.of("pan", "lift"), "points", List.of(POINT));

  private final ScriptedPlugin plugin = new ScriptedPlugin();
  private final FollowActions actions = new FollowActions(plugin);
  private final List<String> progress = new ArrayList<>();
  private final List<DynamicRecord> feedback = new ArrayList<>();
  private boolean cancelsAtFeedback;

  private ActionReply send(Map<String, Object> goal) throws CallException {
    return actions.handle(new CallHandler.Invocation<>() {
      @Override
      public ActionRequest request() {
        return new ActionRequest("/" + ACTION, goal);
      }

      @Override
      public long deadlineNanos() {
        return Long.MAX_VALUE;
      }

      @Override
      public void progress(double fraction, String message) {
        progress.add(message);
      }

      @Override
      public void feedback(DynamicRecord record) {
        feedback.add(record);
        if (cancelsAtFeedback) {
          Thread.currentThread().interrupt();
        }
      }
    });
  }

  private static Object field(DynamicRecord record, String path) {
    return record.at(FieldPath.parse(path))
        .map(value -> value instanceof FieldValue.Num number ? number.value() : value).orElse("missing");
  }

  private static String ended(ActionReply reply) {
    return reply.end() + " " + field(reply.result().orElseThrow(), "error_code") + " " + reply.text();
  }

  @Test
  void aTrajectoryIsToldFollowedAndReached() throws CallException {
    plugin.reports("TAG moving TAG moving 0.4", "TAG settling TAG settling 1.6", "TAG done TAG done 1.7");
    assertEquals(List.of(ACTION), actions.names());

    assertEquals("SUCCEEDED 0.0 ", ended(send(Map.of("trajectory", WAY, "path_tolerance",
        List.of(Map.of("name", "lift", "position", 0.1)), "goal_time_tolerance", Map.of("sec", 2, "nanosec", 0)))));

    assertEquals(List.of("begin;joints pan lift;point 1.5;positions 0.5 1;path 0.1 lift;patience 2;run"),
        plugin.orders());
    assertEquals(List.of("executing"), progress);
    assertEquals(List.of(0.1, 0.25, 0.25 - 0.4, 0.2), List.of(field(feedback.getFirst(), "actual.positions[0]"),
        field(feedback.getFirst(), "desired.positions[1]"), field(feedback.getFirst(), "error.positions[1]"),
        field(feedback.getFirst(), "desired.velocities[0]")));
  }

  @Test
  void whatIsRefusedSaysWhyByACode() throws CallException {
    assertEquals("REJECTED -2.0 'tail' is no joint of this robot",
        ended(send(Map.of("trajectory", Map.of("joint_names", List.of("tail"))))));
    assertEquals("REJECTED -1.0 there is no point",
        ended(send(Map.of("trajectory", Map.of("joint_names", List.of("pan"))))));
    assertTrue(ended(send(Map.of("trajectory", Map.of("header", Map.of("stamp", 1_000_000_000L), "joint_names",
        List.of("pan"), "points", List.of(POINT))))).startsWith("REJECTED -3.0 its last point was to be reached "));
    plugin.reports("TAG bad_joints 0 none 0");
    assertEquals("REJECTED -2.0 not that", ended(send(Map.of("trajectory", WAY))));
    plugin.reports("TAG refused 0 none 0");
    assertEquals("REJECTED -1.0 not that", ended(send(Map.of("trajectory", WAY))));
    plugin.reports("77 telling 0 none 0");
    assertEquals("REJECTED -1.0 another client told Arm another trajectory", ended(send(Map.of("trajectory", WAY))));
    assertThrows(CallException.class, () -> send(Map.of("trajectory", "north")));
    assertEquals(List.of(), progress);
  }

  @Test
  void whatIsGivenUpSaysWhy() throws CallException {
    plugin.reports("TAG moving TAG moving 0.1", "TAG moving TAG off_path 0.2");
    assertEquals("ABORTED -4.0 given up", ended(send(Map.of("trajectory", WAY))));
    plugin.reports("TAG moving TAG off_goal 0.2");
    assertEquals("ABORTED -5.0 given up", ended(send(Map.of("trajectory", WAY))));
    plugin.reports("TAG moving TAG moving 0.1", "9 moving 9 moving 0");
    assertEquals("PREEMPTED 0.0 another trajectory took over", ended(send(Map.of("trajectory", WAY))));
  }

  @Test
  void whoIsCancelledComesToRest() throws CallException {
    plugin.reports("TAG moving TAG moving 0.1");
    plugin.reportsOnceStopped("TAG moving TAG stopped 0.2");
    cancelsAtFeedback = true;

    assertEquals("PREEMPTED 0.0 cancelled", ended(send(Map.of("trajectory", WAY))));

    assertEquals("stop", plugin.orders().getLast());
  }

  @Test
  void nothingIsReadOfWhatIsNoReport() {
    for (String text : List.of("", "1 moving 1 moving", "1 flying 1 moving 0\n\n\n\n\n",
        "x moving 1 moving 0\n\n\n\n\n", "1 moving 1 moving 0\n\n\n1 x\n\n", "1 moving 1 moving 0")) {
      assertEquals(Optional.empty(), FollowReport.read(text), text);
    }
  }
}
