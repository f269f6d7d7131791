package org.robotui.script.internal.function;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.robotui.api.command.Authority;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.Browser;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.Port;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.robotui.script.internal.engine.PlainText;

/** Asking robots: services, actions, plugins, settings, and what they have. */
final class CallFunctions {
  private static final double PATIENCE = 10;

  private CallFunctions() {}

  static List<ScriptFunction> functions() {
    return List.of(
        ScriptFunction.of("call(port, fields, seconds?, ui?)",
            "Asks a robot and waits for its reply (10 s, or those seconds), for example"
                + " call(\"base.services\", {service: \"/reset\"}). Tasks need control.",
            "the reply", CallFunctions::call),
        ScriptFunction.of("browse(kind, ui?)",
            "Lists what the robots have. The kind is topic, service, node, parameter, action or tunable.",
            "a list of {name, type}", CallFunctions::browse),
        ScriptFunction.of("parameter(name, ui?)", "Reads a setting of a robot.", "its value, null where it is not set",
            call -> asked(() -> browser(call, 1).parameter(call.text(0)).orElse(null))),
        ScriptFunction.of("setParameter(name, value, ui?)", "Changes a setting of a robot; needs control.", "",
            call -> asked(() -> {
              browser(call, 2).setParameter(call.text(0),
                  call.argument(1).orElseThrow(() -> new ScriptFailure("a setting cannot be null")));
              return null;
            })));
  }

  private static Object call(ScriptCall call) throws ScriptFailure, InterruptedException {
    SourceId target = Named.port(call, 0);
    Ruic ruic = Named.ruic(call, 3);
    PortAccess access = call.access(ruic);
    Duration limit = call.seconds(2, PATIENCE);
    Optional<Port> port = access.port(PortKind.CALL, target);
    if (!(port.orElse(null) instanceof CallPort<?, ?> asked)) {
      throw new ScriptFailure("no call " + target + " is offered now; see ports()");
    }
    String robot = ruic.authority(target.component()).map(Authority::robot).orElse(ruic.name());
    Call<?> under = access.call(target, new RecordMaker(robot).make(asked.request(), call.fields(1)), limit,
        Progress.IGNORED);
    return outcome(call, target, under, limit);
  }

  private static Object outcome(ScriptCall call, SourceId target, Call<?> under, Duration limit)
      throws ScriptFailure, InterruptedException {
    CompletableFuture<Object> end = new CompletableFuture<>();
    under.outcome().thenAccept(end::complete);
    try {
      Waiting.until(call, limit.plusSeconds(5), end::isDone);
    } catch (InterruptedException e) {
      under.cancel();
      throw e;
    }
    return switch (end.getNow(new CallOutcome.TimedOut<>())) {
      case CallOutcome.Replied<?> replied -> replied.reply();
      case CallOutcome.Failed<?> failed -> throw new ScriptFailure(target + ": " + failed.reason());
      case CallOutcome.Cancelled<?> cancelled -> throw new ScriptFailure(target + ": the call was cancelled");
      default -> throw new ScriptFailure(target + " has not answered within " + PlainText.of(limit));
    };
  }

  private static Object browse(ScriptCall call) throws ScriptFailure, InterruptedException {
    Browser.Kind kind = List.of(Browser.Kind.values()).stream()
        .filter(k -> Named.word(k).equals(call.argument(0).orElse(""))).findFirst()
        .orElseThrow(() -> new ScriptFailure("browse(kind): the kind is one of "
            + String.join(", ", List.of(Browser.Kind.values()).stream().map(Named::word).toList())));
    return asked(() -> browser(call, 1).list(kind).stream().map(CallFunctions::described).toList());
  }

  private static Map<String, Object> described(Item item) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("name", item.name());
    all.put("type", item.type());
    return all;
  }

  private static Browser browser(ScriptCall call, int ui) throws ScriptFailure {
    Ruic ruic = Named.ruic(call, ui);
    PortAccess access = call.access(ruic);
    return ruic.snapshot().ports().stream().filter(p -> p.kind() == PortKind.BROWSE)
        .flatMap(p -> access.browser(p.port()).stream()).findFirst()
        .orElseThrow(() -> new ScriptFailure(ruic.name() + " cannot be browsed now"));
  }

  /** A question that may block. */
  private interface Question {
    Object ask() throws CallException, ScriptFailure;
  }

  private static Object asked(Question question) throws ScriptFailure {
    try {
      return question.ask();
    } catch (CallException e) {
      throw new ScriptFailure(e.getMessage());
    }
  }
}
