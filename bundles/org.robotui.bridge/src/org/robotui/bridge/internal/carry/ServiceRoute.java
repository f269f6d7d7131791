package org.robotui.bridge.internal.carry;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Settings;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.ServiceGrant;
import org.robotui.api.port.ServiceOffer;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.SourceId;
import org.robotui.bridge.internal.change.FrameRenaming;
import org.robotui.bridge.internal.change.ServiceMapping;
import org.robotui.bridge.internal.change.StampMoving;
import org.robotui.bridge.internal.change.ValueRewriting;
import org.robotui.bridge.internal.far.AskedRobot;
import org.robotui.data.record.DynamicRecord;

/** A service between two robot UIs that are there: offered to one, answered by the other. */
final class ServiceRoute implements AutoCloseable {
  private static final String SERVE = "serve";
  private static final Duration TIMELY = Duration.ofSeconds(5);

  private final BridgeConfig config;
  private final Ruic asking;
  private final Ruic answering;
  private final PortAccess near;
  private final PortAccess beyond;
  private final AskedRobot robot;
  private final ServiceMapping mapping;
  private final SourceId serve;
  private volatile boolean closed;

  private ServiceRoute(BridgeConfig config, Ruic asking, Ruic answering, Principal principal) {
    Settings settings = config.settings();
    this.config = config;
    this.asking = asking;
    this.answering = answering;
    this.near = asking.access(principal);
    this.beyond = answering.access(principal);
    this.robot = new AskedRobot(config.to(), answering, beyond, settings);
    this.serve = new SourceId(config.from().port().component(), SERVE);
    FrameRenaming frames = FrameRenaming.of(settings, answering.name());
    this.mapping = ServiceMapping.of(settings,
        new ValueRewriting(frames, StampMoving.of(settings, false, asking.clock(), answering.clock())),
        new ValueRewriting(frames.back(asking.name()),
            StampMoving.of(settings, true, answering.clock(), asking.clock())));
  }

  static Optional<ServiceRoute> of(BridgeConfig config, Principal principal, CarryContext surroundings) {
    return surroundings.ruic(config.from()).flatMap(asking -> surroundings.ruic(config.to())
        .map(answering -> new ServiceRoute(config, asking, answering, principal)));
  }

  boolean isCurrent(CarryContext now) {
    return now.ruic(config.from()).filter(r -> r == asking).isPresent()
        && now.ruic(config.to()).filter(r -> r == answering).isPresent();
  }

  AskedRobot robot() {
    return robot;
  }

  /** Why it cannot be offered now. */
  Optional<String> missing() {
    if (near.port(PortKind.CALL, serve).isEmpty()) {
      BridgeEnd from = config.from();
      return Optional.of("nothing can be offered to '" + from.ruic() + "." + from.port().component()
          + "' now: its connection is down, or programs of its framework cannot be given services");
    }
    return robot.isThere() ? Optional.empty() : Optional.of(robot.missing());
  }

  /**
   * Offers it, or goes on to. Blocks.
   *
   * @throws CallException where it cannot be offered, with what would help
   */
  ServiceGrant offer(Calls calls) throws CallException {
    Settings settings = config.settings();
    AskedRobot.Found found = robot.find(!settings.has("type"));
    String type = settings.has("type") ? settings.text("type") : found.type();
    if (type.isEmpty()) {
      throw new CallException("the type of " + config.to() + " is not known: give the bridge the type of the service"
          + " that it offers with 'type', such as std_srvs/Trigger");
    }
    ServiceOffer offer = new ServiceOffer(config.from().port().port(), type,
        (request, caller) -> calls.answered(() -> ask(found.name(), request)));
    CompletableFuture<CallOutcome<?>> outcome = new CompletableFuture<>();
    near.call(serve, offer, TIMELY, Progress.IGNORED).outcome().thenAccept(outcome::complete);
    return switch (outcome.join()) {
      case CallOutcome.Replied<?> replied when replied.reply() instanceof ServiceGrant grant -> grant;
      case CallOutcome.Failed<?> failed -> throw new CallException(failed.reason());
      default -> throw new CallException(config.from() + " could not be offered within " + TIMELY.toSeconds() + " s");
    };
  }

  /** Counts calls. */
  interface Calls {
    CompletionStage<CallOutcome<ServiceReply>> answered(Asked asked);
  }

  /** A call that is to be made. */
  interface Asked {
    CompletionStage<CallOutcome<ServiceReply>> begin();
  }

  private CompletionStage<CallOutcome<ServiceReply>> ask(String service, DynamicRecord request) {
    if (closed) {
      return CompletableFuture.completedStage(new CallOutcome.Failed<>("the bridge '" + config.name() + "' has ended"));
    }
    try {
      return robot.ask(service, mapping.request(request)).thenApply(this::mapped);
    } catch (IllegalArgumentException e) {
      return CompletableFuture.completedStage(new CallOutcome.Failed<>(String.valueOf(e.getMessage())));
    }
  }

  private CallOutcome<ServiceReply> mapped(CallOutcome<ServiceReply> outcome) {
    try {
      return outcome instanceof CallOutcome.Replied<ServiceReply> replied
          ? new CallOutcome.Replied<>(new ServiceReply(mapping.reply(replied.reply().value())))
          : outcome;
    } catch (IllegalArgumentException e) {
      return new CallOutcome.Failed<>(String.valueOf(e.getMessage()));
    }
  }

  /** What is offered ends some seconds later, and is refused until then. */
  @Override
  public void close() {
    closed = true;
    robot.close();
    near.close();
    beyond.close();
  }
}
