package org.robotui.message.data;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.NavigationStatus.State;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.message.ros.move_base_msgs.MoveBaseActionResult;
import org.robotui.message.ros.move_base_msgs.MoveBaseResult;
import org.robotui.message.ros.std_msgs.Header;

class NavigationAdaptersTest {
  @Test
  void aResultTellsHowAGoalEndedAndWhy() {
    assertEquals(new NavigationStatus("/move_base-1", State.ABORTED, "Failed to find a valid plan."),
        of(GoalStatus.ABORTED, "Failed to find a valid plan."));
    assertEquals(State.REJECTED, of(GoalStatus.REJECTED, "").state());
    assertEquals(State.SUCCEEDED, of(GoalStatus.SUCCEEDED, "").state());
    assertEquals(State.CANCELED, of(GoalStatus.PREEMPTED, "").state());
    assertEquals(State.ACTIVE, of(GoalStatus.ACTIVE, "").state());
  }

  @SuppressWarnings("unchecked")
  private static NavigationStatus of(int status, String text) {
    Adapter<MoveBaseActionResult, NavigationStatus> adapter =
        (Adapter<MoveBaseActionResult, NavigationStatus>) NavigationAdapters.all().stream()
            .filter(a -> a.type().endsWith("Result")).findFirst().orElseThrow();
    MoveBaseActionResult message = new MoveBaseActionResult(new Header(0, 0, ""),
        new GoalStatus(new GoalID(0, "/move_base-1"), status, text), new MoveBaseResult());
    return adapter.convert().apply(message, null).orElseThrow();
  }
}
