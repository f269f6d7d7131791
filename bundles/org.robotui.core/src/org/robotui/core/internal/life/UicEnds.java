package org.robotui.core.internal.life;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Match;
import org.robotui.api.port.BrowseInput.Robot;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Port;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.command.CommandTarget;
import org.robotui.core.internal.command.OutputEnd;
import org.robotui.core.internal.port.BrowseEnd;
import org.robotui.core.internal.port.BrowseTarget;
import org.robotui.core.internal.port.CallTarget;
import org.robotui.core.internal.port.CallerEnd;
import org.robotui.core.internal.port.InputEnd;
import org.robotui.core.internal.port.Offered;
import org.robotui.core.internal.port.StreamSource;

/** The ends of all ports of one view. They exist for its whole life; matching connects and disconnects them. */
final class UicEnds {
  private record Key(PortKind kind, String name) {}

  private final Map<Key, InputEnd<?>> inputs = new HashMap<>();
  private final Map<Key, OutputEnd<?>> outputs = new HashMap<>();
  private final Map<Key, CallerEnd<?, ?>> callers = new HashMap<>();
  private final Map<Key, BrowseEnd> browsers = new HashMap<>();
  private final Map<Key, Port> ports = new HashMap<>();
  private final Principal principal;

  UicEnds(List<Port> declared, Services services, Principal principal, Supplier<Authority> fallback, Executor answers) {
    this.principal = principal;
    for (Port port : declared) {
      Key key = key(port);
      ports.put(key, port);
      switch (port) {
        case StreamPort<?> s -> inputs.put(key, new InputEnd<>(s.intake(), services.clock()));
        case CommandPort<?> c -> outputs.put(key, new OutputEnd<>(principal, fallback, services.clock()));
        case CallPort<?, ?> c -> callers.put(key, new CallerEnd<>(principal, answers));
        case BrowsePort b -> browsers.put(key, new BrowseEnd());
      }
    }
  }

  private static Key key(Port port) {
    return new Key(port.kind(), port.name());
  }

  InputEnd<?> input(StreamPort<?> port) {
    return inputs.get(known(port));
  }

  OutputEnd<?> output(CommandPort<?> port) {
    return outputs.get(known(port));
  }

  CallerEnd<?, ?> caller(CallPort<?, ?> port) {
    return callers.get(known(port));
  }

  BrowseEnd browser(BrowsePort port) {
    return browsers.get(known(port));
  }

  /** The declared port must be the asked one, not just carry its name: the types make the casts above it safe. */
  private Key known(Port port) {
    Key key = key(port);
    if (!port.equals(ports.get(key))) {
      throw new IllegalArgumentException("the port '" + port.name() + "' is not among those of the view's type");
    }
    return key;
  }

  /** Connects one port as matching says. */
  void connect(Match match, List<Offered> peers) {
    Key key = new Key(match.kind(), match.port().port());
    switch (match.kind()) {
      case STREAM -> connectInput(inputs.get(key), peers, match.reason());
      case COMMAND -> connectOutput(outputs.get(key), peers, match.reason());
      case CALL -> connectCaller(callers.get(key), peers, match.reason());
      case BROWSE -> browsers.get(key).connect(peers.stream().map(this::robot).toList());
    }
  }

  private Robot robot(Offered peer) {
    BrowseTarget target = (BrowseTarget) peer;
    return new Robot(target.id(), target.browserFor(principal));
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // matching has compared the types
  private static void connectInput(InputEnd end, List<Offered> peers, String reason) {
    end.connect(peers.stream().map(p -> (StreamSource) p).toList(), reason);
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // matching has compared the types
  private static void connectOutput(OutputEnd end, List<Offered> peers, String reason) {
    end.connect(peers.stream().map(p -> (CommandTarget) p).toList(), reason);
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // matching has compared the types
  private static void connectCaller(CallerEnd end, List<Offered> peers, String reason) {
    end.connect(peers.stream().map(p -> (CallTarget) p).toList(), reason);
  }

  /** The sources that a stream port of the view takes from now. */
  List<SourceId> sources(Match match) {
    return Optional.ofNullable(inputs.get(new Key(match.kind(), match.port().port()))).map(InputEnd::sources)
        .orElse(List.of());
  }

  /** Disconnects all; what the view moved is stopped. */
  void close() {
    outputs.values().forEach(o -> o.connect(List.of(), "the view has ended"));
    inputs.values().forEach(i -> i.connect(List.of(), "the view has ended"));
    callers.values().forEach(c -> c.connect(List.of(), "the view has ended"));
    browsers.values().forEach(b -> b.connect(List.of()));
  }
}
