package org.robotui.bridge.internal.carry;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.config.Settings;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.ServiceGrant;
import org.robotui.api.port.SourceId;
import org.robotui.bridge.internal.change.FrameRenaming;
import org.robotui.bridge.internal.change.ServiceMapping;
import org.robotui.bridge.internal.change.StampMoving;
import org.robotui.bridge.internal.change.ValueRewriting;
import org.robotui.bridge.internal.far.AskedRobot;
import org.robotui.bridge.internal.far.MappedCall;
import org.robotui.data.record.DynamicRecord;

/** A service or an action between two robot UIs that are there: offered to one, answered by the other. */
final class ServiceRoute implements AutoCloseable {
  private static final String CALLS = "services";
  private static final Duration TIMELY = Duration.ofSeconds(5);

  private final BridgeConfig config;
  private final WayEnds ends;
  private final Offering offering;
  private final Ruic asking;
  private final Ruic answering;
  private final PortAccess near;
  private final PortAccess beyond;
  private final AskedRobot robot;
  private final ServiceMapping mapping;
  private final SourceId serve;
  private volatile boolean closed;

  private ServiceRoute(BridgeConfig config, WayEnds ends, Ruic asking, Ruic answering) {
    Settings settings = config.settings();
    this.config = config;
    this.ends = ends;
    this.offering = Offering.of(settings);
    this.asking = asking;
    this.answering = answering;
    this.near = asking.access(ends.principal());
    this.beyond = answering.access(ends.principal());
    this.robot = new AskedRobot(ends.to(), answering, beyond, settings, offering.patience(settings));
    this.serve = new SourceId(ends.from().port().component(), offering.port());
    FrameRenaming frames = FrameRenaming.of(settings, answering.name());
    this.mapping = ServiceMapping.of(settings,
        new ValueRewriting(frames, StampMoving.of(settings, false, asking.clock(), answering.clock())),
        new ValueRewriting(frames.back(asking.name()),
            StampMoving.of(settings, true, answering.clock(), asking.clock())));
  }

  static Optional<ServiceRoute> of(BridgeConfig config, WayEnds ends, CarryContext surroundings) {
    return surroundings.ruic(ends.from()).flatMap(asking -> surroundings.ruic(ends.to())
        .map(answering -> new ServiceRoute(config, ends, asking, answering)));
  }

  boolean isCurrent(CarryContext now) {
    return ends.stillJoin(asking, answering, now);
  }

  AskedRobot robot() {
    return robot;
  }

  /** Why it cannot be offered now. */
  Optional<String> missing() {
    if (near.port(PortKind.CALL, serve).isEmpty()) {
      BridgeEnd from = ends.from();
      String who = "'" + from.ruic() + "." + from.port().component() + "'";
      boolean connected = near.port(PortKind.CALL, new SourceId(from.port().component(), CALLS)).isPresent();
      return Optional.of(connected
          ? who + " cannot be offered " + offering.word() + "s: its protocol lets nobody but the robot serve any"
          : "nothing can be offered to " + who + " now: its connection is down, or programs of its framework cannot be"
              + " given " + offering.word() + "s");
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
    AskedRobot.Found found = robot.find(offering.kind(), !settings.has("type"));
    String type = settings.has("type") ? settings.text("type") : found.kind() == offering.kind() ? found.type() : "";
    if (type.isEmpty()) {
      throw new CallException("the type of " + ends.to() + " is not known: give the bridge the type of the "
          + offering.word() + " that it offers with 'type', such as " + offering.example());
    }
    Object offer = offering.offer(ends.from().port().port(), type,
        (request, progress) -> calls.answered(() -> ask(found, request, progress)));
    CompletableFuture<CallOutcome<?>> outcome = new CompletableFuture<>();
    near.call(serve, offer, TIMELY, Progress.IGNORED).outcome().thenAccept(outcome::complete);
    return switch (outcome.join()) {
      case CallOutcome.Replied<?> replied when replied.reply() instanceof ServiceGrant grant -> grant;
      case CallOutcome.Failed<?> failed -> throw new CallException(failed.reason());
      default -> throw new CallException(ends.from() + " could not be offered within " + TIMELY.toSeconds() + " s");
    };
  }

  /** Counts calls. */
  interface Calls {
    Call<ActionReply> answered(Supplier<Call<ActionReply>> asked);
  }

  private Call<ActionReply> ask(AskedRobot.Found found, DynamicRecord request, Progress progress) {
    if (closed) {
      return MappedCall.failed("the bridge '" + config.name() + "' has ended");
    }
    boolean judged = offering == Offering.ACTION && found.kind() == Kind.SERVICE;
    try {
      return MappedCall.of(robot.ask(found, mapping.request(request), new MappedProgress(progress, mapping)),
          outcome -> mapped(judged ? Offering.judged(outcome) : outcome));
    } catch (IllegalArgumentException e) {
      return MappedCall.failed(String.valueOf(e.getMessage()));
    }
  }

  private CallOutcome<ActionReply> mapped(CallOutcome<ActionReply> outcome) {
    try {
      return outcome instanceof CallOutcome.Replied<ActionReply> replied
          ? new CallOutcome.Replied<>(new ActionReply(replied.reply().end(), replied.reply().text(),
              replied.reply().result().map(mapping::reply)))
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
