package org.robotui.rfic.xbot.internal;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.xbot.Board;
import org.robotui.xbot.Board.PluginState;

/** The service {@code stop_plugins}: stops every plugin that runs, whoever started it. The joints hold then. */
final class StopService implements CallHandler<ServiceRequest, ServiceReply> {
  static final String NAME = "stop_plugins";
  private static final Duration EACH = Duration.ofMillis(500);

  private final Verbs verbs;
  private final Supplier<Optional<Board>> board;

  StopService(Verbs verbs, Supplier<Optional<Board>> board) {
    this.verbs = verbs;
    this.board = board;
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException {
    String service = invocation.request().service();
    if (!service.replaceFirst("^/", "").equals(NAME)) {
      throw new CallException("there is no service " + service + "; there is " + NAME);
    }
    Board now = board.get().orElseThrow(() -> new CallException("the control says nothing that can be read"));
    List<String> left = stopAll(now);
    if (!left.isEmpty()) {
      throw new CallException("not stopped: " + String.join("; ", left));
    }
    return new ServiceReply(new MapRecord(NAME, Map.of("success", new FieldValue.Flag(true))));
  }

  /** Tries all, also where one cannot be stopped, and says which could not. */
  private List<String> stopAll(Board now) {
    List<String> left = new ArrayList<>();
    for (Board.Plugin plugin : now.plugins()) {
      if (!plugin.io() && (plugin.state() == PluginState.RUNNING || plugin.state() == PluginState.STARTING)) {
        stop(plugin.name()).ifPresent(left::add);
      }
    }
    return left;
  }

  private Optional<String> stop(String plugin) {
    try {
      PluginReply reply = verbs.ask(new PluginRequest(plugin, PluginRequest.Verb.STOP, ""), EACH);
      return reply.done() ? Optional.empty() : Optional.of(reply.text());
    } catch (CallException e) {
      return Optional.of(plugin + ": " + e.getMessage());
    }
  }
}
