package org.robotui.script.internal.function;

import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.robotui.script.internal.engine.PlainText;

/** Robot UIs: which there are, how they do, beginning and ending them. */
final class UiFunctions {
  private UiFunctions() {}

  static List<ScriptFunction> functions() {
    return List.of(
        ScriptFunction.of("uis()", "Lists the robot UIs.", "a list of {name, state, link, reason}",
            call -> call.host().ruics().stream().map(UiFunctions::described).toList()),
        ScriptFunction.of("use(ui)", "Chooses the robot UI that all other functions use where they are told no other.",
            "its name", UiFunctions::use),
        ScriptFunction.of("waitForLink(seconds?, ui?)",
            "Waits until all robot interfaces of a robot UI are connected (else fails after 30 s, or those seconds).",
            "", UiFunctions::waitForLink),
        ScriptFunction.of("components(ui?)", "Lists the robot interfaces and views of a robot UI.",
            "a list of {id, type, kind, state, reason}",
            call -> Named.ruic(call, 0).snapshot().components().stream().map(UiFunctions::described).toList()),
        ScriptFunction.of("load(file)", "Opens a configuration, as the window does; its robot UIs are added.",
            "a list of what is wrong with it",
            call -> call.host().load(Path.of(call.text(0))).stream().map(Problem::toString).toList()),
        ScriptFunction.of("restart(component?, ui?)", "Restarts a robot interface or a view, or the whole robot UI.",
            "", UiFunctions::restart),
        ScriptFunction.of("remove(ui)", "Ends a robot UI and takes it away; its robot is stopped where we drive it.",
            "", UiFunctions::remove));
  }

  private static Map<String, Object> described(Ruic ruic) {
    RuicSnapshot now = ruic.snapshot();
    Map<String, Object> ui = new LinkedHashMap<>();
    ui.put("name", now.name());
    ui.put("state", Named.word(now.state()));
    ui.put("link", now.link().word());
    ui.put("reason", now.reason().isEmpty() ? now.link().reason() : now.reason());
    return ui;
  }

  private static Map<String, Object> described(ComponentStatus component) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("id", component.id());
    all.put("type", component.type());
    all.put("kind", component.kind() == ComponentStatus.Kind.RFIC ? "interface" : "view");
    all.put("state", Named.word(component.state()));
    all.put("reason", component.reason());
    return all;
  }

  private static Object use(ScriptCall call) throws ScriptFailure {
    Ruic ruic = call.ruic(Optional.of(call.text(0)));
    call.use(ruic);
    return ruic.name();
  }

  private static Object waitForLink(ScriptCall call) throws ScriptFailure, InterruptedException {
    Duration limit = call.seconds(0, Waiting.LONG.toSeconds());
    Ruic ruic = Named.ruic(call, 1);
    if (Waiting.until(call, limit, () -> ruic.snapshot().link() instanceof LinkState.Connected).isEmpty()) {
      LinkState link = ruic.snapshot().link();
      throw new ScriptFailure(ruic.name() + " was not connected within " + PlainText.of(limit) + ": " + link.word()
          + (link.reason().isEmpty() ? "" : ", " + link.reason()));
    }
    return null;
  }

  private static Object restart(ScriptCall call) throws ScriptFailure, InterruptedException {
    Ruic ruic = Named.ruic(call, 1);
    Optional<String> component = call.textIf(0);
    if (component.isEmpty()) {
      await(call, ruic.restart());
      return null;
    }
    if (ruic.snapshot().components().stream().noneMatch(c -> c.id().equals(component.get()))) {
      throw new ScriptFailure(ruic.name() + " has no component '" + component.get() + "'; see components()");
    }
    ruic.restart(component.get());
    return null;
  }

  private static Object remove(ScriptCall call) throws ScriptFailure, InterruptedException {
    await(call, call.ruic(Optional.of(call.text(0))).remove());
    return null;
  }

  private static void await(ScriptCall call, CompletionStage<RuicState> end)
      throws ScriptFailure, InterruptedException {
    if (Waiting.until(call, Waiting.LONG, () -> end.toCompletableFuture().isDone()).isEmpty()) {
      throw new ScriptFailure("it has not ended within " + Waiting.LONG.toSeconds() + " s");
    }
  }
}
