package org.robotui.uic.actions.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.Principal;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.MapRecord;
import org.robotui.testkit.FakeCaller;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.ui.ask.Asker;
import org.robotui.ui.ask.Catalogue.Entry;

class ActionAskerTest {
  private static final Entry MOVE =
      new Entry(new SourceId("base", "graph"), new Item(Kind.ACTION, "/move_base", "move_base_msgs/MoveBaseAction"));

  private final FakeUicContext context = new FakeUicContext("actions", new ActionsType().schema());
  private final FakeCaller<ActionRequest, ActionReply> caller = new FakeCaller<>(new SourceId("base", "actions"));
  private final List<String> told = new ArrayList<>();

  private final Asker.Report report = new Asker.Report() {
    @Override
    public void progress(String words) {
      told.add(words);
    }

    @Override
    public void feedback(DynamicRecord record) {
      told.add("feedback " + record.schema());
    }

    @Override
    public void end(Health health, String words, Optional<DynamicRecord> result) {
      told.add(health + " " + words + result.map(r -> " " + r.schema()).orElse(""));
    }
  };

  @BeforeEach
  void connect() {
    context.caller(ActionsType.ACTIONS, caller);
  }

  private Runnable ask() {
    return new ActionAsker(context).ask(MOVE, Map.of("x", 1.0), report);
  }

  @Test
  void takesTheControlWhereNobodyHasItAndFollowsTheGoal() {
    ask();
    assertEquals(Optional.of(context.principal()), context.authority().holder());
    FakeCaller.Made<ActionRequest, ActionReply> made = caller.made().getFirst();
    made.progress().at(Double.NaN, "active");
    made.progress().feedback(new MapRecord("MoveBaseFeedback", Map.of()));
    made.end().complete(new CallOutcome.Replied<>(
        new ActionReply(ActionReply.End.ABORTED, "no path", Optional.of(new MapRecord("MoveBaseResult", Map.of())))));
    assertEquals(List.of("sent", "active", "feedback MoveBaseFeedback", "BAD aborted: no path MoveBaseResult"), told);
  }

  @Test
  void sendsNothingWhereSomebodyElseHasTheControl() {
    context.authority().take(new Principal("anna", "Anna", Principal.Kind.WINDOW), true);
    ask();
    assertEquals(List.of(), caller.made());
    assertTrue(told.getLast().contains("Anna has control"), told.toString());
  }

  @Test
  void cancellingIsAskedOfTheRobotWhichSaysHowItEnded() {
    Runnable cancel = ask();
    cancel.run();
    FakeCaller.Made<ActionRequest, ActionReply> made = caller.made().getFirst();
    assertTrue(made.cancelled().isDone());
    made.end().complete(new CallOutcome.Replied<>(new ActionReply(ActionReply.End.PREEMPTED, "", Optional.empty())));
    assertEquals(List.of("sent", "cancelling", "WARNING preempted"), told);
  }
}
