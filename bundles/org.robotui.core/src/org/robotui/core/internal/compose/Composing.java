package org.robotui.core.internal.compose;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.robotui.api.ComponentType;
import org.robotui.api.RuicType;
import org.robotui.api.host.Composition;
import org.robotui.api.host.CompositionState;
import org.robotui.api.host.CompositionState.Stage;
import org.robotui.api.host.CompositionText;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicDraft;
import org.robotui.api.host.RuicView;
import org.robotui.api.host.ViewFit;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Port;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.ConfigSource;
import org.robotui.core.internal.life.LoneInterface;
import org.robotui.core.internal.life.Services;
import org.robotui.core.internal.match.Have;
import org.robotui.core.internal.match.Supplier;
import org.robotui.core.internal.match.ViewFits;

/** A RUIC that is put together, with a robot interface that runs for it alone. */
public final class Composing implements Composition {
  /** A robot that is there answers sooner; what comes later is shown all the same. */
  private static final Duration PATIENCE = Duration.ofSeconds(8);

  /** A robot that is only looked at has no name yet, but frames want one. */
  private static final String UNNAMED = "robot";

  private final InterfaceConfig wanted;
  private final Services services;
  private final LoneInterface robot;
  private final Drafting drafting;
  private final long began;

  /**
   * Starts the robot interface.
   *
   * @param wanted how it is configured
   * @param services of the host
   * @param configs reads configurations
   */
  public Composing(InterfaceConfig wanted, Services services, ConfigSource configs) {
    this.wanted = wanted;
    this.services = services;
    this.began = services.clock().nanos();
    ComponentConfig config = new ComponentConfig(wanted.id(), wanted.type(), wanted.title(),
        wanted.robot().isBlank() ? UNNAMED : wanted.robot(),
        services.check().written(wanted.settings()), "", 0, 0);
    this.robot = new LoneInterface(config, "new", services);
    this.drafting = new Drafting(configs, services.registry(), wanted,
        () -> services.ruics().get().stream().map(RuicView::name).toList());
  }

  @Override
  public CompositionState state() {
    Supplier supplier = robot.supplier();
    Optional<String> failure = robot.failure();
    boolean up = robot.isUp();
    List<Port> always = robot.type().map(ComponentType::ports).orElse(List.of());
    boolean known = !up && always.stream().anyMatch(p -> p.kind() == PortKind.STREAM || p.kind() == PortKind.COMMAND);
    Stage stage = stage(failure.isPresent(), up, known, supplier.settled());
    List<Have> haves = known ? always.stream().map(p -> new Have(new SourceId(wanted.id(), p.name()), p)).toList()
        : up ? robot.offers().stream().map(o -> new Have(o.id(), o.port())).toList() : List.of();
    List<ViewFit> views = ViewFits.of(services.registry().uics(), haves,
        List.of(known ? new Supplier(wanted.id(), true, "") : supplier));
    List<PortStatus> ports = known ? haves.stream().map(Composing::offered).toList()
        : up ? robot.offers().stream().map(o -> o.status(services.clock())).toList() : List.of();
    return new CompositionState(stage, sentence(stage, failure, haves.size()), robot.link(), ports, views,
        RuicFits.of(ruics(), views));
  }

  private Stage stage(boolean failed, boolean up, boolean known, boolean settled) {
    if (failed) {
      return Stage.FAILED;
    }
    if (up) {
      return settled ? Stage.FOUND : Stage.LOOKING;
    }
    boolean late = robot.link() instanceof LinkState.Failed || services.clock().nanos() - began > PATIENCE.toNanos();
    return !late ? Stage.CONNECTING : known ? Stage.KNOWN : Stage.UNREACHED;
  }

  private String sentence(Stage stage, Optional<String> failure, int ports) {
    return switch (stage) {
      case FAILED -> failure.orElse("it cannot be started");
      case CONNECTING -> "connecting" + reason();
      case LOOKING -> ports + " ports so far; still looking for more";
      case FOUND -> ports == 0 ? "connected, but the robot offers nothing; start its programs"
          : "connected; " + ports + " ports";
      case KNOWN -> "what this type always offers is known, so you can go on; the robot is not reached" + reason();
      case UNREACHED -> "not reached" + reason()
          + ". Start the robot's software, check address and port, and connect again; without it nobody knows what it offers";
    };
  }

  private String reason() {
    String reason = robot.link().reason();
    return reason.isEmpty() ? "" : ": " + reason;
  }

  private static PortStatus offered(Have have) {
    return new PortStatus(have.id(), have.port().kind(), have.port().typeName(), false, 0, 0, Double.NaN, false, 0, "",
        "");
  }

  private List<RuicType> ruics() {
    return services.registry().ruicIds().stream().flatMap(id -> services.registry().ruic(id).stream()).toList();
  }

  @Override
  public CompositionText text(RuicDraft draft) {
    return drafting.text(draft);
  }

  @Override
  public CompositionText write(RuicDraft draft, CompositionText.Text shown) {
    return drafting.write(draft, shown);
  }

  @Override
  public void close() {
    robot.close();
  }

  /** Ends the robot interface, and tells when it has ended. */
  CompletableFuture<Void> end() {
    CompletableFuture<Void> ended = new CompletableFuture<>();
    robot.closeThen(() -> ended.complete(null));
    return ended;
  }
}
