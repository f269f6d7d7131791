package org.robotui.uic.actions.internal;

import java.time.Duration;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Authority.LeaseOutcome;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.DynamicRecord;
import org.robotui.ui.Health;
import org.robotui.ui.ask.Asker;
import org.robotui.ui.ask.Catalogue.Entry;

/** Sends goals. Takes the lease where nobody has it; where somebody else has, nothing is sent. */
final class ActionAsker implements Asker {
  private final UicContext context;
  private final Caller<ActionRequest, ActionReply> caller;

  ActionAsker(UicContext context) {
    this.context = context;
    this.caller = context.caller(ActionsType.ACTIONS);
  }

  @Override
  public Runnable ask(Entry entry, Map<String, Object> values, Report report) {
    Optional<String> held = held(entry);
    if (held.isPresent()) {
      report.end(Health.BAD, held.get(), Optional.empty());
      return () -> {};
    }
    Duration timeout = Duration.ofSeconds(Math.round(context.settings().current().number(ActionsType.TIMEOUT)));
    SourceId target = caller.targets().stream().filter(t -> t.component().equals(entry.robot().component())).findFirst()
        .orElse(new SourceId(entry.robot().component(), ActionsType.ACTIONS.name()));
    report.progress("sent");
    Caller.Call<ActionReply> call =
        caller.call(target, new ActionRequest(entry.item().name(), values), timeout, progress(report));
    call.outcome().thenAccept(outcome -> tell(outcome, report));
    return () -> {
      report.progress("cancelling");
      call.cancel();
    };
  }

  private Optional<String> held(Entry entry) {
    return context.ruic().authority(entry.robot().component()).flatMap(this::holder);
  }

  private Optional<String> holder(Authority authority) {
    return authority.take(context.principal(), false) instanceof LeaseOutcome.HeldBy other
        ? Optional.of(other.holder().label() + " has control of " + authority.robot() + "; take it over first")
        : Optional.empty();
  }

  private static Caller.Progress progress(Report report) {
    return new Caller.Progress() {
      @Override
      public void at(double fraction, String message) {
        report.progress(message);
      }

      @Override
      public void feedback(DynamicRecord record) {
        report.feedback(record);
      }
    };
  }

  private static void tell(CallOutcome<ActionReply> outcome, Report report) {
    switch (outcome) {
      case CallOutcome.Replied<ActionReply> r -> tell(r.reply(), report);
      case CallOutcome.Failed<ActionReply> f -> report.end(Health.BAD, f.reason(), Optional.empty());
      case CallOutcome.TimedOut<ActionReply> t -> report.end(Health.BAD, "not done in time; cancelled",
          Optional.empty());
      case CallOutcome.Cancelled<ActionReply> c -> report.end(Health.WARNING,
          "cancelled; the robot has not said how it ended", Optional.empty());
    }
  }

  private static void tell(ActionReply reply, Report report) {
    String word = reply.end().name().toLowerCase(Locale.ROOT);
    report.end(health(reply.end()), reply.text().isEmpty() ? word : word + ": " + reply.text(), reply.result());
  }

  private static Health health(ActionReply.End end) {
    return switch (end) {
      case SUCCEEDED -> Health.OK;
      case PREEMPTED, RECALLED -> Health.WARNING;
      case ABORTED, REJECTED, LOST -> Health.BAD;
    };
  }
}
