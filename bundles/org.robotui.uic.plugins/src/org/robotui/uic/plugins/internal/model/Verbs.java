package org.robotui.uic.plugins.internal.model;

import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.api.port.PluginRequest.Verb;
import org.robotui.ui.Health;
import org.robotui.ui.ask.ControlFirst;

/**
 * Asks the control to do something with a plugin or the drives, once the user has control of the robot. One request a
 * plugin at a time. All threads.
 */
public final class Verbs {
  private final Caller<PluginRequest, PluginReply> caller;
  private final ControlFirst control;
  private final Supplier<Duration> timeout;
  private final Set<String> pending = new HashSet<>();
  private final Map<String, PluginNotice> told = new HashMap<>();

  Verbs(Caller<PluginRequest, PluginReply> caller, ControlFirst control, Supplier<Duration> timeout) {
    this.caller = caller;
    this.control = control;
    this.timeout = timeout;
  }

  /** Whether there is a control to be asked. */
  public boolean isConnected() {
    return !caller.targets().isEmpty();
  }

  /** Asks; words are for commands only. */
  public void ask(String plugin, Verb verb, String words) {
    if (!isConnected()) {
      tell(plugin, new PluginNotice(Health.BAD, "Not asked: no control is connected that switches plugins"));
    } else if (begin(plugin)) {
      control.with(caller.targets().getFirst().component(), () -> send(new PluginRequest(plugin, verb, words)),
          () -> end(plugin, PluginNotice.NOTHING));
    }
  }

  private synchronized boolean begin(String plugin) {
    return pending.add(plugin);
  }

  private void send(PluginRequest request) {
    tell(request.plugin(), new PluginNotice(Health.WAITING, doing(request) + "\u2026"));
    caller.call(request, timeout.get(), Caller.Progress.IGNORED).outcome()
        .thenAccept(outcome -> end(request.plugin(), answer(request, outcome)));
  }

  private synchronized void end(String plugin, PluginNotice answer) {
    pending.remove(plugin);
    told.put(plugin, answer);
  }

  private synchronized void tell(String plugin, PluginNotice what) {
    told.put(plugin, what);
  }

  /** What was told of a plugin that has changed since is no longer true. */
  synchronized void changed(String plugin) {
    if (!pending.contains(plugin)) {
      told.remove(plugin);
    }
  }

  synchronized boolean isPending(String plugin) {
    return pending.contains(plugin);
  }

  synchronized Map<String, PluginNotice> told() {
    return Map.copyOf(told);
  }

  private static PluginNotice answer(PluginRequest request, CallOutcome<PluginReply> outcome) {
    return switch (outcome) {
      case CallOutcome.Replied<PluginReply> replied when replied.reply().done() -> new PluginNotice(Health.OK,
          done(request) + said(replied.reply().text(), ": "));
      case CallOutcome.Replied<PluginReply> replied -> new PluginNotice(Health.BAD,
          failed(request) + said(replied.reply().text(), ": "));
      case CallOutcome.Failed<PluginReply> failed -> new PluginNotice(Health.BAD,
          failed(request) + said(failed.reason(), ": "));
      case CallOutcome.TimedOut<PluginReply> late -> new PluginNotice(Health.BAD,
          failed(request) + ": the control did not answer in time");
      case CallOutcome.Cancelled<PluginReply> gone -> new PluginNotice(Health.WARNING,
          failed(request) + ": it was cancelled");
    };
  }

  private static String said(String text, String before) {
    return text.isBlank() ? "" : before + text.strip();
  }

  private static String doing(PluginRequest request) {
    return switch (request.verb()) {
      case START -> "Starting " + request.plugin();
      case STOP -> "Stopping " + request.plugin();
      case SWITCH_TOGETHER -> "Switching several plugins together";
      case RELOAD -> "Reloading " + request.plugin();
      case COMMAND -> "Sending \u201c" + request.words() + "\u201d";
      case ENABLE_DRIVES -> "Enabling the drives";
      case DISABLE_DRIVES -> "Disabling the drives";
      case RECOVER_DRIVES -> "Bringing drives back";
    };
  }

  private static String done(PluginRequest request) {
    return switch (request.verb()) {
      case START -> "Started";
      case STOP -> "Stopped";
      case SWITCH_TOGETHER -> "Switched together";
      case RELOAD -> "Reloaded";
      case COMMAND -> "\u201c" + request.words() + "\u201d was taken";
      case ENABLE_DRIVES -> "The hardware was asked to enable the drives";
      case DISABLE_DRIVES -> "The hardware was asked to disable the drives";
      case RECOVER_DRIVES -> "The hardware was asked to bring the drives back";
    };
  }

  private static String failed(PluginRequest request) {
    return switch (request.verb()) {
      case START -> "Not started";
      case STOP -> "Not stopped";
      case SWITCH_TOGETHER -> "Not switched together";
      case RELOAD -> "Not reloaded";
      case COMMAND -> "\u201c" + request.words() + "\u201d was not taken";
      case ENABLE_DRIVES -> "Drives not enabled";
      case DISABLE_DRIVES -> "Drives not disabled";
      case RECOVER_DRIVES -> "Drives not brought back";
    };
  }
}
