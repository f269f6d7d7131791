package org.robotui.script.internal.engine;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Host;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.script.ScriptFailure;

/** What the scripts of one session use: the core, the ports, the right to command. Safe for all threads. */
final class Surroundings {
  private final Host host;
  private final Principal principal;
  private final Consumer<String> output;
  private final Map<Ruic, PortAccess> accesses = new HashMap<>(); // under the lock
  private Optional<String> used = Optional.empty(); // under the lock
  private boolean closed; // under the lock

  Surroundings(Host host, Principal principal, Consumer<String> output) {
    this.host = host;
    this.principal = principal;
    this.output = output;
  }

  Host host() {
    return host;
  }

  Principal principal() {
    return principal;
  }

  void print(String text) {
    output.accept(text);
  }

  synchronized void use(Ruic ruic) {
    used = Optional.of(ruic.name());
  }

  Ruic ruic(Optional<String> name) throws ScriptFailure {
    Optional<String> wanted = name.or(this::used);
    return host.ruics().stream().filter(r -> wanted.isEmpty() || r.name().equals(wanted.get())).findFirst()
        .orElseThrow(() -> new ScriptFailure(
            wanted.map(n -> "there is no robot UI '" + n + "'; there are: " + names()).orElse("there is no robot UI")));
  }

  private synchronized Optional<String> used() {
    return used;
  }

  private String names() {
    return host.ruics().isEmpty() ? "none" : host.ruics().stream().map(Ruic::name).collect(Collectors.joining(", "));
  }

  synchronized PortAccess access(Ruic ruic) {
    PortAccess access = accesses.computeIfAbsent(ruic, r -> r.access(principal));
    if (closed) {
      access.close();
    }
    return access;
  }

  /** Stops what was moved. */
  synchronized void release() {
    accesses.values().forEach(PortAccess::release);
  }

  /** Stops what was moved, and gives back what was taken control of. */
  synchronized void close() {
    closed = true;
    accesses.values().forEach(PortAccess::close);
    host.ruics().stream().flatMap(r -> r.authorities().stream()).forEach(a -> a.giveBack(principal));
  }
}
