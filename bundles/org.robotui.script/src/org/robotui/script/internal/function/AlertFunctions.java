package org.robotui.script.internal.function;

import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertBoard;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;

/** Alerts of a robot UI. */
final class AlertFunctions {
  private static final double USUAL_MUTE = 600;

  private AlertFunctions() {}

  static List<ScriptFunction> functions() {
    return List.of(
        ScriptFunction.of("alerts(ui?)", "Lists the alerts.",
            "a list of {name, view, condition, source, value, since, lasting, acknowledged}",
            call -> Named.ruic(call, 0).alerts().alerts().stream().map(AlertFunctions::described).toList()),
        ScriptFunction.of("acknowledge(name, ui?)", "Acknowledges the alerts of a name.", "", call -> {
          AlertBoard board = Named.ruic(call, 1).alerts();
          of(call, board).forEach(a -> board.acknowledge(a.id()));
          return null;
        }),
        ScriptFunction.of("mute(name, seconds?, ui?)", "Mutes the alerts of a name for 10 minutes, or those seconds.",
            "", call -> {
              AlertBoard board = Named.ruic(call, 2).alerts();
              Instant until = Instant.now().plus(call.seconds(1, USUAL_MUTE));
              of(call, board).forEach(a -> board.mute(a.id(), Optional.of(until)));
              return null;
            }));
  }

  private static Map<String, Object> described(Alert alert) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("name", alert.id().name());
    all.put("view", alert.id().view());
    all.put("condition", alert.condition());
    all.put("source", alert.source());
    all.put("value", alert.value());
    all.put("since", alert.since().toString());
    all.put("lasting", alert.lasting());
    all.put("acknowledged", alert.acknowledged());
    return all;
  }

  private static List<Alert> of(ScriptCall call, AlertBoard board) throws ScriptFailure {
    String name = call.text(0);
    List<Alert> found = board.alerts().stream().filter(a -> a.id().name().equals(name)).toList();
    if (found.isEmpty()) {
      throw new ScriptFailure("there is no alert '" + name + "'; see alerts()");
    }
    return found;
  }
}
