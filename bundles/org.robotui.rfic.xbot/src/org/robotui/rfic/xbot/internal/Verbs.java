package org.robotui.rfic.xbot.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.regex.Pattern;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.xbot.Answer;
import org.robotui.xbot.RtClient;

/** Asks the supervisor what users ask of plugins and drives. */
final class Verbs implements CallHandler<PluginRequest, PluginReply> {
  private static final Pattern PAIRS = Pattern.compile("\\S+ [01]( \\S+ [01])*");

  private final RtClient client;

  Verbs(RtClient client) {
    this.client = client;
  }

  @Override
  public PluginReply handle(Invocation<PluginRequest> invocation) throws CallException {
    return ask(invocation.request(),
        Duration.ofNanos(Math.max(1_000_000, invocation.deadlineNanos() - System.nanoTime())));
  }

  PluginReply ask(PluginRequest request, Duration timeout) throws CallException {
    try {
      Answer answer = client.request(words(request), timeout);
      return new PluginReply(answer.ok(), answer.text());
    } catch (IOException e) {
      throw new CallException(e.getMessage(), e);
    }
  }

  private static String words(PluginRequest request) throws CallException {
    if (!isOfDrives(request.verb()) && !isName(request.plugin())) {
      throw new CallException("'" + request.plugin() + "' is no name of a plugin");
    }
    return switch (request.verb()) {
      case START -> "switch " + request.plugin() + " 1";
      case STOP -> "switch " + request.plugin() + " 0";
      case SWITCH_TOGETHER -> "switch " + pairs(request.words());
      case RELOAD -> "reload " + request.plugin();
      case COMMAND -> "command " + request.plugin() + " " + request.words();
      case ENABLE_DRIVES -> "enable";
      case DISABLE_DRIVES -> "disable";
      case RECOVER_DRIVES -> "recover";
    };
  }

  private static String pairs(String words) throws CallException {
    if (!PAIRS.matcher(words).matches()) {
      throw new CallException("'" + words + "' are no names of plugins with 1 or 0 behind each");
    }
    return words;
  }

  private static boolean isName(String plugin) {
    return !plugin.isBlank() && plugin.chars().noneMatch(Character::isWhitespace);
  }

  private static boolean isOfDrives(PluginRequest.Verb verb) {
    return switch (verb) {
      case ENABLE_DRIVES, DISABLE_DRIVES, RECOVER_DRIVES -> true;
      case START, STOP, SWITCH_TOGETHER, RELOAD, COMMAND -> false;
    };
  }
}
