package org.robotui.bridge.internal.far;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.command.Authority;
import org.robotui.api.config.Settings;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.Browser;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.SourceId;

/**
 * The robot that answers what programs of another one ask. A call may move it, so that it needs the lease like a
 * command, unless it is configured otherwise. Safe for all threads.
 */
public final class AskedRobot {
  private static final String SERVICES = "services";
  private static final String TYPE = "type";

  private final BridgeEnd end;
  private final Ruic ruic;
  private final PortAccess access;
  private final ControlClaim control;
  private final boolean guarded;
  private final Duration patience;
  private final SourceId services;
  private final AtomicInteger open = new AtomicInteger();

  /**
   * A service as the robot has it.
   *
   * @param name its whole name
   * @param type the name of its type; empty where the robot does not say
   */
  public record Found(String name, String type) {}

  /** Closes neither. */
  public AskedRobot(BridgeEnd end, Ruic ruic, PortAccess access, Settings settings) {
    this.end = end;
    this.ruic = ruic;
    this.access = access;
    this.control = new ControlClaim(access.principal());
    this.guarded = !settings.has("lease") || settings.flag("lease");
    this.patience = Duration.ofNanos(Math.round(settings.number("timeout") * 1e9));
    this.services = new SourceId(end.port().component(), SERVICES);
  }

  /** Whether it can be asked now. */
  public boolean isThere() {
    return access.port(PortKind.CALL, services).isPresent();
  }

  /** What is missing. */
  public String missing() {
    return "'" + end.ruic() + "." + end.port().component() + "' cannot be asked now: it offers no calls";
  }

  /**
   * Looks for the service. Blocks.
   *
   * @param typed whether its type is to be asked for
   * @throws CallException where it is not there, with what is
   */
  public Found find(boolean typed) throws CallException {
    Optional<Browser> browser = ruic.snapshot().ports().stream()
        .filter(port -> port.kind() == PortKind.BROWSE && port.port().component().equals(end.port().component()))
        .flatMap(port -> access.browser(port.port()).stream()).findFirst();
    if (browser.isEmpty()) {
      return new Found(end.port().port(), "");
    }
    Item item = named(browser.get().list(Kind.SERVICE));
    String type = !typed || !item.type().isEmpty() ? item.type()
        : browser.get().describe(item).facts().getOrDefault(TYPE, "");
    return new Found(item.name(), type);
  }

  /** By its whole name, also without the slash, or by the end of it where there is one of that. */
  private Item named(List<Item> items) throws CallException {
    String name = end.port().port();
    List<Item> whole = items.stream().filter(i -> i.name().equals(name) || i.name().equals("/" + name)).toList();
    List<Item> ending = items.stream().filter(i -> i.name().endsWith("/" + name)).toList();
    if (whole.isEmpty() && ending.size() != 1) {
      throw new CallException(ending.isEmpty() ? "'" + end.ruic() + "' has no service '" + name + "' now"
          : "'" + end.ruic() + "' has several services '" + name + "': "
              + String.join(", ", ending.stream().map(Item::name).toList()) + "; write the whole name");
    }
    return whole.isEmpty() ? ending.getFirst() : whole.getFirst();
  }

  /** Asks; the answer never completes exceptionally. */
  public CompletionStage<CallOutcome<ServiceReply>> ask(String service, Map<String, Object> arguments) {
    Optional<String> obstacle = guarded ? obstacle() : Optional.empty();
    if (obstacle.isPresent()) {
      return CompletableFuture.completedStage(new CallOutcome.Failed<>(obstacle.get()));
    }
    open.incrementAndGet();
    return access.call(services, new ServiceRequest(service, arguments), patience, Progress.IGNORED).outcome()
        .thenApply(this::ended);
  }

  private CallOutcome<ServiceReply> ended(CallOutcome<?> outcome) {
    open.decrementAndGet();
    return switch (outcome) {
      case CallOutcome.Replied<?> replied when replied
          .reply() instanceof ServiceReply reply -> new CallOutcome.Replied<>(reply);
      case CallOutcome.Replied<?> other -> new CallOutcome.Failed<>(end + " has given no answer of a service");
      case CallOutcome.Failed<?> failed -> new CallOutcome.Failed<>(failed.reason());
      case CallOutcome.TimedOut<?> late -> new CallOutcome.Failed<>(
          end + " has not answered within " + patience.toMillis() / 1e3 + " s ('timeout' of the bridge)");
      case CallOutcome.Cancelled<?> cancelled -> new CallOutcome.Failed<>("the call of " + end + " was ended");
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
    if (open.get() == 0) {
      control.tick(authority(), now);
    }
  }

  /** Who has control of the robot, where asking needs it. */
  public Optional<String> holder() {
    return guarded ? authority().flatMap(Authority::holder).map(holder -> holder.label()) : Optional.empty();
  }

  /** Gives the lease back. */
  public synchronized void close() {
    authority().ifPresent(control::giveBack);
  }
}
