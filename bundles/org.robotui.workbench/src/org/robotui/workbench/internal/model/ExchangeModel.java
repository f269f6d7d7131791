package org.robotui.workbench.internal.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.stream.Stream;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.Exchange;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.host.Host;
import org.robotui.api.host.Installed;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.SourceId;

/** What the user wants in the place of a robot interface, and the trial of it. One thread. */
public final class ExchangeModel implements AutoCloseable {
  /** The name of the robot is asked for with the settings of the type, as it is written beside them. */
  private static final String ROBOT = "robot";

  private final Ruic ruic;
  private final List<Installed> types;
  private InterfaceConfig wanted;
  private Optional<Exchange> trial = Optional.empty();
  private Optional<InterfaceConfig> tried = Optional.empty();

  /** Begins with the first robot interface of a RUIC as it runs. */
  public ExchangeModel(Host host, Ruic ruic) {
    this.ruic = ruic;
    this.types = host.installed().stream().filter(t -> t.kind() == Installed.Kind.RFIC).toList();
    this.wanted = ruic.interfaces().getFirst();
  }

  /** The RUIC. */
  public Ruic ruic() {
    return ruic;
  }

  /** Its robot interfaces as they run. */
  public List<InterfaceConfig> interfaces() {
    return ruic.interfaces();
  }

  /** The frameworks that are installed. */
  public List<Installed> types() {
    return types;
  }

  /** The framework that is wanted, where it is installed. */
  public Optional<Installed> type() {
    return types.stream().filter(t -> t.descriptor().id().equals(wanted.type())).findFirst();
  }

  /** What is wanted now. */
  public InterfaceConfig wanted() {
    return wanted;
  }

  /** How the interface runs now. */
  public Optional<InterfaceConfig> now() {
    return ruic.interfaces().stream().filter(i -> i.id().equals(wanted.id())).findFirst();
  }

  /** As it stands in the file, where it runs otherwise. */
  public Optional<InterfaceConfig> written() {
    return ruic.written(wanted.id());
  }

  /** Wants something else; a trial of what was wanted before ends. */
  public void want(InterfaceConfig next) {
    if (!next.equals(wanted)) {
      wanted = next;
      close();
    }
  }

  /** Another framework: its settings begin with those of the same name. */
  public void type(String id) {
    want(new InterfaceConfig(wanted.id(), id, wanted.robot(), wanted.title(), wanted.settings()));
  }

  /** All that can be said of the framework: the robot's name, and its own settings. */
  public Schema schema() {
    Setting robot = Setting.of(ROBOT, new ValueType.Text(), now().map(InterfaceConfig::robot).orElse(wanted.robot()),
        "name of the robot: frames, safety and the lease are by robot");
    List<Setting> own = type().map(t -> t.descriptor().schema().settings()).orElse(List.of());
    return new Schema(Stream.concat(Stream.of(robot), own.stream()).toList());
  }

  /** What the form begins with. */
  public Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>(wanted.settings());
    values.put(ROBOT, wanted.robot());
    return values;
  }

  /** Takes what the form holds. */
  public void values(Map<String, Object> given) {
    Map<String, Object> settings = new LinkedHashMap<>(given);
    String robot = Optional.ofNullable(settings.remove(ROBOT)).map(Object::toString)
        .orElseGet(() -> now().map(InterfaceConfig::robot).orElse(""));
    want(new InterfaceConfig(wanted.id(), wanted.type(), robot, wanted.title(), settings));
  }

  /** Whether nothing would change. */
  public boolean isUnchanged() {
    return now().filter(wanted::equals).isPresent();
  }

  /** Starts a trial of what is wanted. */
  public void tryIt() {
    close();
    trial = Optional.of(ruic.exchange(wanted));
    tried = Optional.of(wanted);
  }

  /** What the trial says so far; nothing where there is none. */
  public Optional<ExchangePreview> preview() {
    return trial.map(Exchange::preview);
  }

  /** Connects a port after the exchange. */
  public void choose(SourceId port, SourceId peer) {
    trial.ifPresent(t -> t.choose(port, peer));
  }

  /** Exchanges what was tried. */
  public CompletionStage<ExchangeOutcome> apply(boolean goWithout) {
    return trial.map(t -> t.apply(goWithout))
        .orElseGet(() -> CompletableFuture.completedFuture(new ExchangeOutcome.Refused("try it first")));
  }

  /** What was tried last. */
  public Optional<InterfaceConfig> tried() {
    return tried;
  }

  /** The trial has ended by itself. */
  public void ended() {
    trial = Optional.empty();
    tried = Optional.empty();
  }

  @Override
  public void close() {
    trial.ifPresent(Exchange::close);
    ended();
  }
}
