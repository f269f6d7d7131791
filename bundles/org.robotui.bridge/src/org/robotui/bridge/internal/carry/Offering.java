package org.robotui.bridge.internal.carry;

import java.time.Duration;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.config.Settings;
import org.robotui.api.port.ActionOffer;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.ServiceOffer;
import org.robotui.api.port.ServiceReply;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

/** What programs of a robot are offered: a service, or an action. */
enum Offering {
  SERVICE(Kind.SERVICE, "serve", "std_srvs/Trigger", Duration.ofSeconds(10)) {
    @Override
    Object offer(String name, String type, Asked asked) {
      return new ServiceOffer(name, type,
          (request, caller) -> asked.begin(request, Progress.IGNORED).outcome().thenApply(Offering::reply));
    }
  },
  ACTION(Kind.ACTION, "serve_action", "nav2_msgs/NavigateToPose", Duration.ofHours(1)) {
    @Override
    Object offer(String name, String type, Asked asked) {
      return new ActionOffer(name, type, (goal, client, progress) -> asked.begin(goal, progress));
    }
  };

  private static final MapRecord NOTHING = new MapRecord("nothing", Map.of());
  private static final FieldValue FALSE = new FieldValue.Flag(false);

  private final Kind kind;
  private final String port;
  private final String example;
  private final Duration patience;

  Offering(Kind kind, String port, String example, Duration patience) {
    this.kind = kind;
    this.port = port;
    this.example = example;
    this.patience = patience;
  }

  /** Begins with what a program asks for. */
  interface Asked {
    Call<ActionReply> begin(DynamicRecord request, Progress progress);
  }

  static Offering of(Settings settings) {
    return settings.text("kind").equals(BridgeWords.ACTION) ? ACTION : SERVICE;
  }

  Kind kind() {
    return kind;
  }

  /** The call of a robot interface that offers it. */
  String port() {
    return port;
  }

  String word() {
    return kind.name().toLowerCase(Locale.ROOT);
  }

  String example() {
    return example;
  }

  /** How long it may take. */
  Duration patience(Settings settings) {
    return settings.has("timeout") ? Duration.ofNanos(Math.round(settings.number("timeout") * 1e9)) : patience;
  }

  abstract Object offer(String name, String type, Asked asked);

  /** A goal is not reached where the service says in its answer that it has not succeeded. */
  static CallOutcome<ActionReply> judged(CallOutcome<ActionReply> outcome) {
    return outcome instanceof CallOutcome.Replied<ActionReply> replied
        && replied.reply().result().flatMap(answer -> answer.field("success")).filter(FALSE::equals).isPresent()
            ? new CallOutcome.Replied<>(new ActionReply(ActionReply.End.ABORTED,
                replied.reply().result().flatMap(answer -> answer.field("message"))
                    .filter(FieldValue.Text.class::isInstance).map(text -> ((FieldValue.Text) text).value()).orElse(""),
                replied.reply().result()))
            : outcome;
  }

  /** A service has no word for a goal that was not reached. */
  private static CallOutcome<ServiceReply> reply(CallOutcome<ActionReply> outcome) {
    return switch (outcome) {
      case CallOutcome.Replied<ActionReply> replied when replied.reply()
          .end() == ActionReply.End.SUCCEEDED -> new CallOutcome.Replied<>(
              new ServiceReply(replied.reply().result().orElse(NOTHING)));
      case CallOutcome.Replied<ActionReply> replied -> new CallOutcome.Failed<>("the goal was "
          + replied.reply().end().name().toLowerCase(Locale.ROOT)
          + Optional.of(replied.reply().text()).filter(text -> !text.isEmpty()).map(text -> ": " + text).orElse(""));
      case CallOutcome.Failed<ActionReply> failed -> new CallOutcome.Failed<>(failed.reason());
      case CallOutcome.TimedOut<ActionReply> late -> new CallOutcome.TimedOut<>();
      case CallOutcome.Cancelled<ActionReply> cancelled -> new CallOutcome.Cancelled<>();
    };
  }
}
