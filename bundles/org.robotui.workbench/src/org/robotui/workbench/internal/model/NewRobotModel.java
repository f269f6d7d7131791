package org.robotui.workbench.internal.model;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.Composition;
import org.robotui.api.host.CompositionState;
import org.robotui.api.host.Host;
import org.robotui.api.host.Installed;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.RuicDraft;
import org.robotui.api.host.RuicFit;
import org.robotui.api.host.ViewFit;
import org.robotui.api.port.SourceId;

/** What the user wants for a new robot: its interface, which is tried, the views, the name and the file. One thread. */
public final class NewRobotModel implements AutoCloseable {
  private static final String ID = "base";
  private static final String FIRST = "ros";
  /** The name of the robot is asked for with the settings of the type, as it is written beside them. */
  private static final String ROBOT = "robot";
  private static final Setting ROBOT_NAME =
      Setting.optional(ROBOT, new ValueType.Text(), "name of the robot; else that of its robot UI");

  private final Host host;
  private final List<Installed> types;
  private InterfaceConfig wanted;
  private Optional<Composition> composition = Optional.empty();
  private Optional<String> ruic = Optional.empty();
  private Optional<Set<String>> views = Optional.empty();
  private final Map<SourceId, SourceId> connections = new LinkedHashMap<>();
  private String name = "";
  private Path file;

  /** Begins with nothing. */
  public NewRobotModel(Host host, Path file) {
    this.host = host;
    this.file = file;
    this.types = host.installed().stream().filter(t -> t.kind() == Installed.Kind.RFIC).toList();
    String type = types.stream().map(t -> t.descriptor().id()).filter(FIRST::equals).findFirst()
        .or(() -> types.stream().map(t -> t.descriptor().id()).findFirst()).orElse("");
    this.wanted = new InterfaceConfig(ID, type, "", "", Map.of());
  }

  /** The frameworks that are installed. */
  public List<Installed> types() {
    return types;
  }

  /** The framework that is wanted. */
  public Optional<Installed> type() {
    return types.stream().filter(t -> t.descriptor().id().equals(wanted.type())).findFirst();
  }

  /** What it can be configured with. */
  public Schema schema() {
    List<Setting> own = type().map(t -> t.descriptor().schema().settings()).orElse(List.of());
    return new Schema(Stream.concat(own.stream().filter(s -> !s.name().equals(ROBOT)), Stream.of(ROBOT_NAME)).toList());
  }

  /** What the form begins with. */
  public Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>(wanted.settings());
    if (!wanted.robot().isEmpty()) {
      values.put(ROBOT, wanted.robot());
    }
    return values;
  }

  /** Another framework, or other settings; what was tried before ends. */
  public void want(String type, Map<String, Object> settings) {
    Map<String, Object> own = new LinkedHashMap<>(settings);
    String robot = Optional.ofNullable(own.remove(ROBOT)).map(Object::toString).orElse("");
    InterfaceConfig next = new InterfaceConfig(ID, type, robot, "", own);
    if (!next.equals(wanted)) {
      wanted = next;
      close();
    }
  }

  /** Connects to the robot. */
  public void connect() {
    close();
    composition = Optional.of(host.compose(wanted));
  }

  /** What was found so far; nothing where nothing was tried. */
  public Optional<CompositionState> state() {
    return composition.map(Composition::state);
  }

  /** What is put together; nothing where nothing was tried. */
  public Optional<Composition> composition() {
    return composition;
  }

  /** The type of RUIC: the user's, else the best. */
  public Optional<RuicFit> ruic(CompositionState state) {
    return ruic.flatMap(state::ruic).or(() -> state.ruics().stream().findFirst());
  }

  /** Another type of RUIC; the views are those that it proposes. */
  public void ruic(String type) {
    ruic = Optional.of(type);
    views = Optional.empty();
  }

  /** The views: the user's, else those that are proposed. */
  public List<String> views(CompositionState state) {
    List<String> proposed = ruic(state).map(r -> state.proposedViews(r.type())).orElse(List.of());
    return views.map(v -> ordered(state, v)).orElse(proposed);
  }

  /** In the order of the layout, then in the order of the table. */
  private List<String> ordered(CompositionState state, Set<String> chosen) {
    Set<String> all = new LinkedHashSet<>(ruic(state).map(RuicFit::views).orElse(List.of()));
    state.views().stream().map(ViewFit::type).forEach(all::add);
    return all.stream().filter(chosen::contains).toList();
  }

  /** Takes a view in, or leaves it out. */
  public void flip(CompositionState state, String view) {
    Set<String> next = new LinkedHashSet<>(views(state));
    if (!next.remove(view)) {
      next.add(view);
    }
    views = Optional.of(next);
  }

  /** Which port goes where, for ports that several fit: the user's choice, else what is proposed. */
  public Map<SourceId, SourceId> connections(CompositionState state) {
    Map<SourceId, SourceId> all = new LinkedHashMap<>(state.proposedConnections(views(state)));
    all.replaceAll((port, peer) -> connections.getOrDefault(port, peer));
    return all;
  }

  /** Ports of views for which the user has chosen. */
  public Set<SourceId> decided() {
    return Set.copyOf(connections.keySet());
  }

  /** Connects a port. */
  public void choose(SourceId port, SourceId peer) {
    connections.put(port, peer);
  }

  /** How it shall be called. */
  public String name() {
    return name;
  }

  /** Names it. */
  public void name(String text) {
    name = text;
  }

  /** Where it is written. */
  public Path file() {
    return file;
  }

  /** Says where. */
  public void file(Path where) {
    file = where;
  }

  /** All that the user wants. */
  public Optional<RuicDraft> draft() {
    return state().flatMap(
        s -> ruic(s).map(r -> new RuicDraft(name.strip(), r.type(), new ArrayList<>(views(s)), connections(s), file)));
  }

  @Override
  public void close() {
    composition.ifPresent(Composition::close);
    composition = Optional.empty();
    connections.clear();
    views = Optional.empty();
    ruic = Optional.empty();
  }
}
