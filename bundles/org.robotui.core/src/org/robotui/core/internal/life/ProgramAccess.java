package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robotui.api.command.Authority;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.CommandOutcome.Refused;
import org.robotui.api.command.CommandOutcome.Why;
import org.robotui.api.command.Principal;
import org.robotui.api.host.PortAccess;
import org.robotui.api.port.Browser;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.Intake;
import org.robotui.api.port.Port;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.command.CommandTarget;
import org.robotui.core.internal.command.OutputEnd;
import org.robotui.core.internal.port.BrowseTarget;
import org.robotui.core.internal.port.CallTarget;
import org.robotui.core.internal.port.CallerEnd;
import org.robotui.core.internal.port.InputEnd;
import org.robotui.core.internal.port.Offered;
import org.robotui.core.internal.port.StreamSource;
import org.robotui.data.Data;

/** The ports of one RUIC for a program, by the same ends as a view has; each is connected anew when it is used. */
final class ProgramAccess implements PortAccess {
  private final Components components;
  private final Services services;
  private final Supplier<Authority> fallback;
  private final Principal principal;
  private final Map<SourceId, InputEnd<Data>> inputs = new HashMap<>();
  private final Map<SourceId, OutputEnd<Data>> outputs = new HashMap<>();
  private volatile Runnable arrivals = () -> {};
  private boolean closed;

  ProgramAccess(Components components, Services services, Supplier<Authority> fallback, Principal principal) {
    this.components = components;
    this.services = services;
    this.fallback = fallback;
    this.principal = principal;
  }

  @Override
  public Principal principal() {
    return principal;
  }

  @Override
  public Optional<Port> port(PortKind kind, SourceId id) {
    return offered(kind, id).map(Offered::port);
  }

  private synchronized Optional<Offered> offered(PortKind kind, SourceId id) {
    return closed ? Optional.empty()
        : components.rfic(id.component()).stream().flatMap(slot -> slot.offers().stream())
            .filter(o -> o.port().kind() == kind && o.id().equals(id)).findFirst();
  }

  private static String missing(PortKind kind, SourceId id) {
    return "no " + kind.name().toLowerCase(Locale.ROOT) + " " + id + " is offered now";
  }

  @Override
  public Optional<Envelope<?>> newest(SourceId stream) {
    return input(stream).latest().map(e -> e);
  }

  @Override
  public int take(SourceId stream, Consumer<? super Envelope<?>> consumer) {
    return input(stream).drain(consumer);
  }

  @Override
  public void onArrival(Runnable told) {
    arrivals = told;
  }

  @Override
  public Optional<List<RawMessage>> held(SourceId stream) {
    return offered(PortKind.STREAM, stream).flatMap(o -> ((StreamSource<?>) o).held());
  }

  @Override
  public InputState state(SourceId stream) {
    return input(stream).state();
  }

  @SuppressWarnings("unchecked") // a stream of anything is one of data
  private synchronized InputEnd<Data> input(SourceId stream) {
    List<StreamSource<Data>> sources =
        offered(PortKind.STREAM, stream).map(o -> (StreamSource<Data>) o).stream().toList();
    InputEnd<Data> end = closed ? input() : inputs.computeIfAbsent(stream, id -> input());
    end.choose(Set.of(stream));
    end.connect(sources, missing(PortKind.STREAM, stream));
    return end;
  }

  private InputEnd<Data> input() {
    return new InputEnd<>(Intake.CHOSEN, services.clock(), () -> arrivals.run());
  }

  @Override
  public CommandOutcome send(SourceId target, Data command, Duration validFor) {
    Optional<Offered> port = offered(PortKind.COMMAND, target);
    if (port.isEmpty()) {
      return new Refused(Why.NOT_CONNECTED, missing(PortKind.COMMAND, target));
    }
    CommandTarget<?> found = (CommandTarget<?>) port.get();
    return found.port().type().isInstance(command) ? output(found).send(command, validFor)
        : new Refused(Why.NOT_CONNECTED, target + " takes " + found.port().typeName() + ", not "
            + command.getClass().getSimpleName());
  }

  @SuppressWarnings("unchecked") // the type of what is sent was compared
  private synchronized OutputEnd<Data> output(CommandTarget<?> target) {
    OutputEnd<Data> end =
        outputs.computeIfAbsent(target.id(), id -> new OutputEnd<>(principal, fallback, services.clock()));
    end.connect(closed ? List.of() : List.of((CommandTarget<Data>) target), "the program has ended");
    return end;
  }

  @Override
  public synchronized void release() {
    outputs.values().forEach(OutputEnd::release);
  }

  @Override
  @SuppressWarnings("unchecked") // the type of the request is compared
  public Call<?> call(SourceId target, Object request, Duration timeout, Progress progress) {
    Optional<CallTarget<Object, Object>> port =
        offered(PortKind.CALL, target).map(o -> (CallTarget<Object, Object>) o);
    String wrong = port.filter(p -> !p.port().request().isInstance(request))
        .map(p -> target + " takes " + p.port().request().getSimpleName()).orElse(missing(PortKind.CALL, target));
    CallerEnd<Object, Object> end = new CallerEnd<>(principal, services.timer());
    end.connect(port.filter(p -> p.port().request().isInstance(request)).stream().toList(), wrong);
    return end.call(request, timeout, progress);
  }

  @Override
  public Optional<Browser> browser(SourceId port) {
    return offered(PortKind.BROWSE, port).map(o -> ((BrowseTarget) o).browserFor(principal));
  }

  @Override
  public synchronized void close() {
    closed = true;
    inputs.values().forEach(end -> end.connect(List.of(), "the program has ended"));
    outputs.values().forEach(end -> end.connect(List.of(), "the program has ended"));
    inputs.clear();
  }
}
