package org.robotui.bridge.internal.far;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.command.Authority;
import org.robotui.api.config.Settings;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.Browser;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.SourceId;

/**
 * The robot that answers what programs of another one ask, by its services or its actions. A call may move it, so that
 * it needs the lease like a command, unless it is configured otherwise; a goal of an action needs it always. Safe for
 * all threads.
 */
public final class AskedRobot {
  private static final String SERVICES = "services";
  private static final String ACTIONS = "actions";
  private static final String TYPE = "type";
  /** As robots say it of goals. */
  private static final String AT_WORK = "active";

  private final BridgeEnd end;
  private final Ruic ruic;
  private final PortAccess access;
  private final ControlClaim control;
  private final boolean guarded;
  private final Duration patience;
  private final Set<Call<?>> open = ConcurrentHashMap.newKeySet();

  /**
   * A service or an action as the robot has it.
   *
   * @param kind which of them
   * @param name its whole name
   * @param type the name of its type; empty where the robot does not say
   */
  public record Found(Kind kind, String name, String type) {}

  /** Closes neither. */
  public AskedRobot(BridgeEnd end, Ruic ruic, PortAccess access, Settings settings, Duration patience) {
    this.end = end;
    this.ruic = ruic;
    this.access = access;
    this.control = new ControlClaim(access.principal());
    this.guarded = !settings.has("lease") || settings.flag("lease");
    this.patience = patience;
  }

  /** Whether it can be asked now. */
  public boolean isThere() {
    return access.port(PortKind.CALL, port(SERVICES)).isPresent()
        || access.port(PortKind.CALL, port(ACTIONS)).isPresent();
  }

  private SourceId port(String name) {
    return new SourceId(end.port().component(), name);
  }

  /** What is missing. */
  public String missing() {
    return "'" + end.ruic() + "." + end.port().component() + "' cannot be asked now: it offers no calls";
  }

  /**
   * Looks for what can be asked. Blocks.
   *
   * @param kind a service or an action, whichever is meant where both are there
   * @param typed whether its type is to be asked for
   * @throws CallException where neither is there, with what is
   */
  public Found find(Kind kind, boolean typed) throws CallException {
    Optional<Browser> browser = NamedItem.browser(end, ruic, access);
    if (browser.isEmpty()) {
      boolean meant = access.port(PortKind.CALL, port(kind == Kind.ACTION ? ACTIONS : SERVICES)).isPresent();
      return new Found(meant ? kind : NamedItem.other(kind), end.port().port(), "");
    }
    Item item = new NamedItem(end, browser.get()).find(kind);
    String type = !typed || !item.type().isEmpty() ? item.type()
        : browser.get().describe(item).facts().getOrDefault(TYPE, "");
    return new Found(item.kind(), item.name(), type);
  }

  /** Asks. What a service answers is a goal that succeeded; the outcome never completes exceptionally. */
  public Call<ActionReply> ask(Found asked, Map<String, Object> arguments, Progress progress) {
    boolean action = asked.kind() == Kind.ACTION;
    Optional<String> obstacle = guarded || action ? obstacle() : Optional.empty();
    if (obstacle.isPresent()) {
      return MappedCall.failed(obstacle.get());
    }
    Call<?> call = access.call(port(action ? ACTIONS : SERVICES), action ? new ActionRequest(asked.name(), arguments)
        : new ServiceRequest(asked.name(), arguments), patience, progress);
    open.add(call);
    if (!action) {
      progress.at(Double.NaN, AT_WORK);
    }
    return new MappedCall(call, outcome -> {
      open.remove(call);
      return ended(outcome);
    });
  }

  private CallOutcome<ActionReply> ended(CallOutcome<?> outcome) {
    return switch (outcome) {
      case CallOutcome.Replied<?> replied -> switch (replied.reply()) {
        case ActionReply reply -> new CallOutcome.Replied<>(reply);
        case ServiceReply reply -> new CallOutcome.Replied<>(
            new ActionReply(ActionReply.End.SUCCEEDED, "", Optional.of(reply.value())));
        default -> new CallOutcome.Failed<>(end + " has given no answer of a service");
      };
      case CallOutcome.Failed<?> failed -> new CallOutcome.Failed<>(failed.reason());
      case CallOutcome.TimedOut<?> late -> new CallOutcome.Failed<>(
          end + " has not answered within " + patience.toMillis() / 1e3 + " s ('timeout' of the bridge)");
      case CallOutcome.Cancelled<?> cancelled -> new CallOutcome.Cancelled<>();
    };
  }

  private synchronized Optional<String> obstacle() {
    Optional<Authority> authority = authority();
    return authority.isEmpty() ? Optional.of("the robot of " + end + " is not there")
        : control.obstacle(authority.get(), false, System.nanoTime());
  }

  private Optional<Authority> authority() {
    return ruic.authority(end.port().component());
  }

  /** Gives the lease back where nothing is asked. */
  public synchronized void tick(long now) {
    if (open.isEmpty()) {
      control.tick(authority(), now);
    }
  }

  /** Who has control of the robot, where asking needs it. */
  public Optional<String> holder() {
    return guarded ? authority().flatMap(Authority::holder).map(holder -> holder.label()) : Optional.empty();
  }

  /** Ends what is asked, and gives the lease back. */
  public synchronized void close() {
    open.forEach(Call::cancel);
    authority().ifPresent(control::giveBack);
  }
}
