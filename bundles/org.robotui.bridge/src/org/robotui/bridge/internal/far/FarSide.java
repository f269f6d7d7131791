package org.robotui.bridge.internal.far;

import java.time.Duration;
import java.util.Optional;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.command.Authority;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.CommandOutcome.Refused;
import org.robotui.api.command.CommandOutcome.Why;
import org.robotui.api.config.Settings;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.command.Motion;
import org.robotui.data.command.MotionLimits;
import org.robotui.data.command.RelayMessage;

/** The robot to which a bridge leads: by its port for commands, where it has one of that name, else by a topic. */
public final class FarSide {
  /** The port of robot interfaces that say what other robots say. */
  private static final String RELAY = "relay";
  private static final Duration TIMELY = Duration.ofSeconds(2);

  private final BridgeEnd end;
  private final Ruic ruic;
  private final PortAccess access;
  private final Settings settings;
  private final ControlClaim control;
  private final SourceId relay;

  /** Whether a value crossed. */
  public sealed interface Passage {
    /** It did, or did not for good; its answer is told, now or soon. */
    record Over() implements Passage {}

    /**
     * It did not yet: too much waits there.
     *
     * @param reason a sentence for users
     */
    record Later(String reason) implements Passage {}

    /**
     * The robot is not there.
     *
     * @param reason a sentence for users
     */
    record Away(String reason) implements Passage {}
  }

  /** Closes neither. */
  public FarSide(BridgeEnd end, Ruic ruic, PortAccess access, Settings settings) {
    this.end = end;
    this.ruic = ruic;
    this.access = access;
    this.settings = settings;
    this.control = new ControlClaim(access.principal());
    this.relay = new SourceId(end.port().component(), RELAY);
  }

  /** Whether something can be said there now. */
  public boolean isThere() {
    return commandPort().isPresent() || access.port(PortKind.COMMAND, relay).isPresent();
  }

  /** What is missing. */
  public String missing() {
    return "nothing can be sent to '" + end.ruic() + "." + end.port().component()
        + "' now: it offers no port for commands '"
        + end.port().port() + "' and none for topics";
  }

  private Optional<CommandPort<?>> commandPort() {
    return access.port(PortKind.COMMAND, end.port()).filter(CommandPort.class::isInstance)
        .map(port -> (CommandPort<?>) port);
  }

  /** Has a value said there. */
  public Passage send(Crossing crossing, long now) {
    Optional<CommandPort<?>> port = commandPort();
    return port.isPresent() ? command(port.get(), crossing, now) : say(crossing, now);
  }

  private Passage command(CommandPort<?> port, Crossing crossing, long now) {
    Data command = limited(FittingCommand.of(port.type(), crossing.value()));
    if (!port.type().isInstance(command)) {
      return refused(crossing, end + " takes " + port.typeName() + ", not " + command.getClass().getSimpleName()
          + "; a 'transform' can make one of the other");
    }
    Optional<String> obstacle = obstacle(command, now);
    if (obstacle.isPresent()) {
      return refused(crossing, obstacle.get());
    }
    Duration expiry = Duration.ofNanos(Math.round(settings.number("expiry") * 1e9));
    CommandOutcome outcome = access.send(end.port(), command, expiry);
    if (outcome instanceof CommandOutcome.Accepted) {
      crossing.answer().told(Optional.empty());
    }
    return passage(crossing, outcome);
  }

  private Data limited(Data command) {
    return command instanceof Motion<?> motion
        ? motion.within(new MotionLimits(limit("max_linear"), limit("max_angular")))
        : command;
  }

  private double limit(String word) {
    return settings.has(word) ? settings.number(word) : Double.POSITIVE_INFINITY;
  }

  private Optional<String> obstacle(Data command, long now) {
    Optional<Authority> authority = ruic.authority(end.port().component());
    return authority.isEmpty() ? Optional.of("the robot of " + end + " is not there")
        : control.obstacle(authority.get(), command, now);
  }

  private Passage say(Crossing crossing, long now) {
    if (access.port(PortKind.COMMAND, relay).isEmpty()) {
      return new Passage.Away(missing());
    }
    boolean guarded = settings.has("lease") ? settings.flag("lease") : !Informing.is(crossing.value());
    Optional<String> obstacle = guarded ? obstacle(crossing.value(), now) : Optional.empty();
    if (obstacle.isPresent()) {
      return refused(crossing, obstacle.get());
    }
    String type = settings.has("type") ? settings.text("type") : "";
    return passage(crossing, access.send(relay, new RelayMessage(end.port().port(), type, crossing.value(),
        crossing.stamp(), crossing.original(), crossing.kept(), guarded, crossing.answer()), TIMELY));
  }

  private static Passage passage(Crossing crossing, CommandOutcome outcome) {
    return switch (outcome) {
      case CommandOutcome.Accepted a -> new Passage.Over();
      case Refused r when r.why() == Why.ROBOT -> new Passage.Later(r.explanation());
      case Refused r when r.why() == Why.LINK_DOWN || r.why() == Why.NOT_CONNECTED -> new Passage.Away(r.explanation());
      case Refused r -> refused(crossing, r.explanation());
    };
  }

  private static Passage refused(Crossing crossing, String reason) {
    crossing.answer().told(Optional.of(reason));
    return new Passage.Over();
  }

  /** What the robot interface said of the last command, where it refused it. */
  public Optional<String> problem() {
    return commandPort().flatMap(port -> ruic.snapshot().ports().stream()
        .filter(p -> p.kind() == PortKind.COMMAND && p.port().equals(end.port())).map(p -> p.problem())
        .filter(problem -> !problem.isEmpty()).findFirst());
  }

  /** Gives the lease back where no commands come. */
  public void tick(long now) {
    control.tick(ruic.authority(end.port().component()), now);
  }

  /** Who has control of the robot, where this bridge commands it. */
  public Optional<String> holder() {
    return commandPort().flatMap(port -> ruic.authority(end.port().component())).flatMap(Authority::holder)
        .map(holder -> holder.label());
  }

  /** What moves by this bridge is stopped. */
  public void close() {
    access.release();
    ruic.authority(end.port().component()).ifPresent(control::giveBack);
  }
}
