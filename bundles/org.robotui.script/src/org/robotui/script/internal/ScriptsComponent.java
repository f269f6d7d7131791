package org.robotui.script.internal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Deactivate;
import org.osgi.service.component.annotations.Reference;
import org.osgi.service.component.annotations.ReferenceCardinality;
import org.osgi.service.component.annotations.ReferencePolicy;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Host;
import org.robotui.api.script.ScriptFunction;
import org.robotui.api.script.ScriptFunctions;
import org.robotui.api.script.ScriptSession;
import org.robotui.api.script.Scripts;
import org.robotui.script.internal.action.ActionRecorder;
import org.robotui.script.internal.engine.Session;
import org.robotui.script.internal.function.StandardFunctions;
import org.robotui.script.internal.socket.ScriptSocket;

/** Scripts as an OSGi service. The engine is loaded with the first session. */
@Component(service = Scripts.class)
public final class ScriptsComponent implements Scripts {
  private final Host host;
  private final AtomicLong counter = new AtomicLong();
  private final List<ScriptFunctions> contributed = new CopyOnWriteArrayList<>();
  private final List<ScriptSession> sessions = new CopyOnWriteArrayList<>();
  private final List<ScriptFunction> standard = StandardFunctions.all(this::functions);

  /** Called by declarative services. */
  @Activate
  public ScriptsComponent(@Reference Host host) {
    this.host = host;
  }

  @Deactivate
  void deactivate() {
    sessions.forEach(ScriptSession::close);
  }

  @Reference(cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC, unbind = "removeFunctions")
  void addFunctions(ScriptFunctions functions) {
    contributed.add(functions);
  }

  void removeFunctions(ScriptFunctions functions) {
    contributed.remove(functions);
  }

  @Override
  public ScriptSession open(String name, Consumer<String> output) {
    Principal principal =
        new Principal("script-" + counter.incrementAndGet(), name, Principal.Kind.SCRIPT);
    List<ScriptSession> self = new ArrayList<>();
    Session session = new Session(host, principal, output, this::functions, () -> sessions.removeAll(self));
    self.add(session);
    sessions.add(session);
    return session;
  }

  /** Of several with one name the first holds: ours, else that which came first. */
  @Override
  public List<ScriptFunction> functions() {
    Map<String, ScriptFunction> all = new TreeMap<>(Comparator.naturalOrder());
    standard.forEach(f -> all.put(f.name(), f));
    contributed.forEach(c -> c.functions().forEach(f -> all.putIfAbsent(f.name(), f)));
    return List.copyOf(all.values());
  }

  @Override
  public Optional<Door> listen(Path folder) {
    return ScriptSocket.open(folder, this);
  }

  @Override
  public ActionRecording record(Consumer<String> line) {
    return new ActionRecorder(host, contributed, line);
  }
}
