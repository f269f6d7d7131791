package org.robotui.script.internal.function;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.host.Match;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptCallback;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.robotui.script.internal.engine.PlainText;

/** What robots send: listing, reading, waiting. */
final class PortFunctions {
  /** How long the first value of a stream may take that nobody has asked the robot for before. */
  private static final Duration FIRST = Duration.ofSeconds(3);
  private static final double PATIENCE = 10;

  private PortFunctions() {}

  static List<ScriptFunction> functions() {
    return List.of(
        ScriptFunction.of("ports(ui?)", "Lists what the robots send and take.",
            "a list of {name, kind, type, rate (Hz), age (s), stale, problem, text}",
            call -> Named.ruic(call, 0).snapshot().ports().stream().map(PortFunctions::described).toList()),
        ScriptFunction.of("value(port, ui?)",
            "Reads the newest value of a stream, in SI units; waits up to 3 s for the first one. help(\"Odometry\") says"
                + " what its fields mean.",
            "an object with the fields of the type", PortFunctions::value),
        ScriptFunction.of("message(port, ui?)",
            "Reads the newest message of a stream with the names that the robot gives.",
            "an object", call -> newest(call).record()),
        ScriptFunction.of("age(port, ui?)", "Says how old the newest value of a stream is.", "seconds",
            PortFunctions::age),
        ScriptFunction.of("take(port, ui?)",
            "Takes all values of a stream that came since the last call, at most 1024; the first call begins.",
            "a list of objects", PortFunctions::take),
        ScriptFunction.of("waitFor(condition, seconds?)",
            "Waits until a function gives something that is true (else fails after 10 s, or those seconds).",
            "what the function gave", PortFunctions::waitFor),
        ScriptFunction.of("waitUntil(port, condition, seconds?, ui?)",
            "Waits for a value of a stream for which a function gives something that is true (else fails after 10 s, or"
                + " those seconds).",
            "the value", PortFunctions::waitUntil),
        ScriptFunction.of("connections(ui?)", "Lists to what the ports of the views are connected, and why.",
            "a list of {port, type, state, peers, candidates, reason}",
            call -> Named.ruic(call, 0).snapshot().matches().stream().map(PortFunctions::described).toList()),
        ScriptFunction.of("connect(viewPort, robotPort, ui?)",
            "Connects a port of a view to one of a robot, as the window of connections does; the choice is kept.", "",
            call -> {
              Named.ruic(call, 2).connect(Named.port(call, 0), Named.port(call, 1));
              return null;
            }));
  }

  private static Map<String, Object> described(PortStatus port) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("name", port.port().toString());
    all.put("kind", Named.word(port.kind()));
    all.put("type", port.typeName());
    all.put("rate", port.rateHz());
    all.put("age", port.ageSeconds());
    all.put("stale", port.stale());
    all.put("problem", port.problem());
    all.put("text", port.value());
    return all;
  }

  private static Map<String, Object> described(Match match) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("port", match.port().toString());
    all.put("type", match.typeName());
    all.put("state", Named.word(match.state()));
    all.put("peers", match.peers().stream().map(SourceId::toString).toList());
    all.put("candidates", match.candidates().stream().map(SourceId::toString).toList());
    all.put("reason", match.reason());
    return all;
  }

  private static Object value(ScriptCall call) throws ScriptFailure, InterruptedException {
    return newest(call).value();
  }

  /** As the port says it: that of a value of a recording does not grow while the recording stands. */
  private static Object age(ScriptCall call) throws ScriptFailure, InterruptedException {
    Envelope<?> newest = newest(call);
    return switch (call.access(Named.ruic(call, 1)).state(Named.port(call, 0))) {
      case InputState.Live live -> live.ageSeconds();
      case InputState.Stale stale -> stale.ageSeconds();
      default -> newest.ageSeconds(System.nanoTime());
    };
  }

  private static Envelope<?> newest(ScriptCall call) throws ScriptFailure, InterruptedException {
    SourceId port = Named.port(call, 0);
    PortAccess access = call.access(Named.ruic(call, 1));
    Optional<Envelope<?>> found = access.newest(port);
    if (found.isEmpty() && access.state(port) instanceof InputState.Waiting) {
      found = Waiting.forSome(call, FIRST, () -> access.newest(port));
    }
    return found.orElseThrow(() -> new ScriptFailure(access.state(port).explanation()));
  }

  private static Object take(ScriptCall call) throws ScriptFailure {
    SourceId port = Named.port(call, 0);
    PortAccess access = call.access(Named.ruic(call, 1));
    List<Object> taken = new ArrayList<>();
    access.take(port, envelope -> taken.add(envelope.value()));
    if (taken.isEmpty() && access.state(port) instanceof InputState.Unconnected unconnected) {
      throw new ScriptFailure(unconnected.explanation());
    }
    return taken;
  }

  private static Object waitFor(ScriptCall call) throws ScriptFailure, InterruptedException {
    ScriptCallback condition = call.function(0);
    Duration limit = call.seconds(1, PATIENCE);
    return Waiting.forSome(call, limit, () -> Optional.ofNullable(condition.call()).filter(PortFunctions::isTrue))
        .orElseThrow(() -> new ScriptFailure("waited for " + PlainText.of(limit) + " in vain"));
  }

  private static Object waitUntil(ScriptCall call) throws ScriptFailure, InterruptedException {
    SourceId port = Named.port(call, 0);
    ScriptCallback condition = call.function(1);
    Duration limit = call.seconds(2, PATIENCE);
    Ruic ruic = Named.ruic(call, 3);
    PortAccess access = call.access(ruic);
    long[] seen = {-1};
    return Waiting.forSome(call, limit, () -> access.newest(port).filter(e -> e.sequence() != seen[0]).filter(e -> {
      seen[0] = e.sequence();
      return isTrue(condition.call(e.value()));
    })).orElseThrow(() -> new ScriptFailure("waited for " + PlainText.of(limit) + " for " + port + " in vain"
        + (access.state(port) instanceof InputState.Live ? "" : " (" + access.state(port).explanation() + ")")))
        .value();
  }

  /** As the language has it. */
  private static boolean isTrue(Object value) {
    return switch (value) {
      case null -> false;
      case Boolean flag -> flag;
      case Number number -> number.doubleValue() != 0 && !Double.isNaN(number.doubleValue());
      case String text -> !text.isEmpty();
      default -> true;
    };
  }
}
