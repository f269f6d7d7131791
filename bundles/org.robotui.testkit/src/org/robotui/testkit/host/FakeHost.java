package org.robotui.testkit.host;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import org.robotui.api.FileKind;
import org.robotui.api.UicType.Surface;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.CheckReport;
import org.robotui.api.host.Composition;
import org.robotui.api.host.ConfigSettings;
import org.robotui.api.host.FileOpener;
import org.robotui.api.host.FileOutcome;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Installed;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Problem;
import org.robotui.api.host.ReuseReport;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.SettingsGroup;
import org.robotui.api.host.SettingsOutcome;
import org.robotui.api.host.WindowConfig;
import org.robotui.api.time.PointedTime;

/** A host with RUICs that a test adds. Safe for all threads. */
public final class FakeHost implements Host {
  /** Who is told, and where. */
  private record Told(HostListener listener, Executor executor) {}

  private final List<FakeRuic> ruics = new CopyOnWriteArrayList<>();
  private final List<Told> listeners = new CopyOnWriteArrayList<>();
  private final List<String> calls = new CopyOnWriteArrayList<>();
  private final AtomicInteger heartbeats = new AtomicInteger();
  private volatile Map<Path, String> texts = Map.of();
  private volatile List<BridgeConfig> bridges = List.of();
  private volatile List<Problem> problems = List.of();
  private volatile ReuseReport reuse = ReuseReport.EMPTY;
  private volatile List<Installed> installed = List.of();
  private volatile List<WindowConfig> windows = List.of();
  private volatile Function<InterfaceConfig, Composition> composing = wanted -> {
    throw new UnsupportedOperationException("no test has said what is composed");
  };
  private volatile List<FileKind> kinds = List.of();
  private volatile Function<Path, FileOutcome> opening =
      file -> new FileOutcome.NotOpened(file, "no robot interface opens it");
  private volatile List<SettingsGroup> groups = List.of();
  private final PointedTime pointed = new PointedTime();
  private volatile BiFunction<SettingsGroup, Map<String, Object>, SettingsOutcome> writing =
      (group, values) -> new SettingsOutcome.Refused("no test has said what is written");
  private volatile BiFunction<Setting, Object, Optional<String>> wrong = (setting, value) -> Optional.empty();

  /**
   * Adds a RUIC and tells the listeners.
   *
   * @param ruic the RUIC
   * @return this
   */
  public FakeHost add(FakeRuic ruic) {
    ruics.add(ruic);
    tell(HostListener::ruicsChanged);
    return this;
  }

  /**
   * Takes a RUIC away and tells the listeners.
   *
   * @param ruic the RUIC
   */
  public void remove(FakeRuic ruic) {
    ruics.remove(ruic);
    tell(HostListener::ruicsChanged);
  }

  /**
   * Sets which files can be opened, and what comes of that.
   *
   * @param values kinds of files
   * @param outcome what comes of opening one
   * @return this
   */
  public FakeHost opening(List<FileKind> values, Function<Path, FileOutcome> outcome) {
    kinds = List.copyOf(values);
    opening = outcome;
    return this;
  }

  /**
   * Sets what loading and checking say.
   *
   * @param values the problems
   * @return this
   */
  public FakeHost finding(Problem... values) {
    problems = List.of(values);
    return this;
  }

  /**
   * Sets what the configurations are.
   *
   * @param values their texts, masked
   * @return this
   */
  public FakeHost configured(Map<Path, String> values) {
    texts = Map.copyOf(values);
    return this;
  }

  @Override
  public Map<Path, String> configurationTexts() {
    return texts;
  }

  /**
   * Sets what types are installed.
   *
   * @param types the types
   * @return this
   */
  public FakeHost installed(Installed... types) {
    installed = List.of(types);
    return this;
  }

  /**
   * Sets what is put together.
   *
   * @param compose is given the wanted robot interface
   * @return this
   */
  public FakeHost composing(Function<InterfaceConfig, Composition> compose) {
    composing = compose;
    return this;
  }

  /**
   * Sets what windows the files ask for.
   *
   * @param names the RUICs that they begin with
   * @return this
   */
  public FakeHost asking(String... names) {
    windows = Stream.of(names).map(n -> new WindowConfig(Path.of("test.yaml"), n, 1)).toList();
    return this;
  }

  /**
   * Sets what bridges the files ask for.
   *
   * @param values the bridges
   * @return this
   */
  public FakeHost bridging(BridgeConfig... values) {
    bridges = List.of(values);
    return this;
  }

  @Override
  public List<BridgeConfig> bridges() {
    return bridges;
  }

  /**
   * Sets what its RUICs use.
   *
   * @param report the matrix
   * @return this
   */
  public FakeHost reusing(ReuseReport report) {
    reuse = report;
    return this;
  }

  /**
   * Sets how values of settings are checked; without it all are fine.
   *
   * @param check gives what is wrong, or nothing
   * @return this
   */
  public FakeHost checking(BiFunction<Setting, Object, Optional<String>> check) {
    wrong = check;
    return this;
  }

  /**
   * Sets what the files can say, and what comes of writing it.
   *
   * @param values the groups
   * @param outcome is given what shall be written
   * @return this
   */
  public FakeHost settable(List<SettingsGroup> values,
      BiFunction<SettingsGroup, Map<String, Object>, SettingsOutcome> outcome) {
    groups = List.copyOf(values);
    writing = outcome;
    return this;
  }

  @Override
  public PointedTime pointed() {
    return pointed;
  }

  @Override
  public ConfigSettings settings() {
    return new ConfigSettings() {
      @Override
      public List<SettingsGroup> groups() {
        return groups;
      }

      @Override
      public SettingsOutcome write(SettingsGroup group, Map<String, Object> values) {
        return writing.apply(group, values);
      }

      @Override
      public Schema always(SettingsGroup.Part part) {
        return Schema.of(Setting.optional("title", new ValueType.Text(), "what users read"));
      }
    };
  }

  /**
   * Tells all listeners, those that named no executor on the calling thread.
   *
   * @param event what to tell them
   */
  public void tell(Consumer<HostListener> event) {
    listeners.forEach(told -> told.executor().execute(() -> event.accept(told.listener())));
  }

  /**
   * What was asked of it, in order, heartbeats left out.
   *
   * @return for example {@code load demo.yaml}
   */
  public List<String> calls() {
    return List.copyOf(calls);
  }

  /**
   * How often the display said that it lives.
   *
   * @return the count
   */
  public int heartbeats() {
    return heartbeats.get();
  }

  /**
   * How many listen.
   *
   * @return the count
   */
  public int listeners() {
    return listeners.size();
  }

  @Override
  public void open(Surface surface, Principal principal) {
    calls.add("open " + surface);
  }

  @Override
  public List<Problem> load(Path file) {
    calls.add("load " + file.getFileName());
    return problems;
  }

  @Override
  public CheckReport check(Path file, Duration wait) {
    calls.add("check " + file.getFileName());
    return new CheckReport(problems, Map.of(), reuse);
  }

  @Override
  public List<Installed> installed() {
    return installed;
  }

  @Override
  public ReuseReport reuse() {
    return reuse;
  }

  @Override
  public Optional<String> wrong(Setting setting, Object value) {
    return wrong.apply(setting, value);
  }

  @Override
  public List<Ruic> ruics() {
    return List.copyOf(ruics);
  }

  @Override
  public List<WindowConfig> windows() {
    return windows;
  }

  @Override
  public Composition compose(InterfaceConfig wanted) {
    return composing.apply(wanted);
  }

  @Override
  public FileOpener files() {
    return new FileOpener() {
      @Override
      public List<FileKind> kinds() {
        return kinds;
      }

      @Override
      public CompletionStage<FileOutcome> open(Path file) {
        calls.add("open " + file.getFileName());
        return CompletableFuture.completedFuture(opening.apply(file));
      }
    };
  }

  @Override
  public Subscription listen(HostListener listener) {
    return listen(listener, Runnable::run);
  }

  /** Tells what a test tells by a task for each: it makes nothing of many one. */
  @Override
  public Subscription listen(HostListener listener, Executor executor) {
    Told told = new Told(listener, executor);
    listeners.add(told);
    return () -> listeners.remove(told);
  }

  @Override
  public void displayAlive() {
    heartbeats.incrementAndGet();
  }

  @Override
  public void displayFocused(boolean focused) {
    calls.add("focused " + focused);
  }

  @Override
  public List<String> support(Path file) throws IOException {
    calls.add("support " + file);
    Files.writeString(file, "facts");
    return List.of("process.txt: this process");
  }

  @Override
  public void stopAll(Principal by) {
    calls.add("stopAll");
    ruics.forEach(r -> r.authority().stop(by));
  }

  @Override
  public Duration closeLimit(Duration limit) {
    return limit;
  }

  @Override
  public List<String> close(Duration limit) {
    calls.add("close");
    return List.of();
  }
}
