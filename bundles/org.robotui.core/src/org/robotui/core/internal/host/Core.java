package org.robotui.core.internal.host;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import org.robotui.api.UicType.Surface;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Setting;
import org.robotui.api.host.CheckReport;
import org.robotui.api.host.Composition;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.ConfigSettings;
import org.robotui.api.host.FileOpener;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Installed;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Problem;
import org.robotui.api.host.ReuseReport;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.WindowConfig;
import org.robotui.api.time.PointedTime;
import org.robotui.core.internal.command.Arbiters;
import org.robotui.core.internal.command.DisplayWatch;
import org.robotui.core.internal.command.StopWarmUp;
import org.robotui.core.internal.compose.Composing;
import org.robotui.core.internal.compose.FileOpening;
import org.robotui.core.internal.compose.WrittenSettings;
import org.robotui.core.internal.config.model.CheckedValue;
import org.robotui.core.internal.config.model.ConfigResult;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.facts.ProcessFacts;
import org.robotui.core.internal.facts.MaskedFiles;
import org.robotui.core.internal.facts.SupportFile;
import org.robotui.core.internal.life.OverlayStore;
import org.robotui.core.internal.life.Plan;
import org.robotui.core.internal.life.RuicRuntime;
import org.robotui.core.internal.life.Services;
import org.robotui.core.internal.life.SharedThreads;
import org.robotui.core.internal.watch.DisplayWatchdog;
import org.robotui.core.internal.watch.MemoryWatch;
import org.robotui.core.internal.watch.SuspectFile;
import org.robotui.core.internal.watch.Watch;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The core, put together. It knows nothing of OSGi. */
public final class Core implements Host {
  private static final Logger LOG = LoggerFactory.getLogger(Core.class);
  private static final Services.Stage NO_STAGE =
      new Services.Stage(Surface.NONE, new Principal("core", "RobotUI", Principal.Kind.SCRIPT));

  private final CoreParts parts;
  private final Notifier notifier = new Notifier();
  private final List<RuicRuntime> ruics = new CopyOnWriteArrayList<>();
  private final Map<Path, OverlayStore> overlays = new ConcurrentHashMap<>();
  private final Map<Path, List<BridgeConfig>> bridges = Collections.synchronizedMap(new LinkedHashMap<>());
  private final Map<Path, List<WindowConfig>> windows = Collections.synchronizedMap(new LinkedHashMap<>());
  private final ScheduledThreadPoolExecutor timer = timer();
  private final ScheduledThreadPoolExecutor files = executor("robotui-files");
  private final HostEvents events = new HostEvents(notifier, ruics::remove);
  private final ConfigWatch configWatch = new ConfigWatch(files, this::reread);
  private final Rereading rereading = new Rereading(this::running);
  private final ProcessFacts facts;
  private final DisplayWatch display;
  private final OutsideStop outside;
  private final Arbiters arbiters;
  private final Watch watch;
  private final Services services;
  private final FileOpening opening;
  private final WrittenSettings settings;
  private volatile Services.Stage stage = NO_STAGE;

  /** A core without RUICs. */
  public Core(CoreParts parts) {
    this.parts = parts;
    this.facts = new ProcessFacts(configWatch::files, () -> RobotFacts.lines(ruics), parts.bundles()::states);
    this.display = new DisplayWatch(parts.clock());
    this.outside = new OutsideStop(parts.state().run(), files, parts.wall());
    this.arbiters = new Arbiters(parts.clock(), display, outside);
    this.watch = new Watch(parts.clock());
    this.services = new Services(parts.registry(), parts.check(), arbiters, events, watch, timer, parts.clock(),
        parts.wall(), parts.state().interfaces(), () -> List.copyOf(ruics),
        parts.bundles(), () -> stage, new PointedTime());
    this.opening = new FileOpening(services, parts.configs(), parts.state()::opened, this::load);
    this.settings = new WrittenSettings(parts.configs(), parts.registry(), parts.check(), configWatch::files,
        () -> ruics.stream().map(RuicRuntime::snapshot).toList());
    watch.add(new DisplayWatchdog(display, parts.bundles(), new SuspectFile(parts.state().suspects()), files,
        this::tellOfDisplay));
    watch.add(new MemoryWatch(MemoryWatch.heap(), () -> arbiters.stopAll(NO_STAGE.principal()),
        message -> events.alert("", message)));
    parts.registry().listen(this::typesChanged);
    files.execute(StopWarmUp::run);
  }

  private void tellOfDisplay(String message) {
    events.notice(message);
    outside.display(message, display.silenceNanos() > DisplayWatch.SILENCE_NANOS);
  }

  private Optional<RuicRuntime> running(String name) {
    return ruics.stream().filter(r -> r.name().equals(name)).findFirst();
  }

  private CompletableFuture<Void> typesChanged() {
    return CompletableFuture.allOf(ruics.stream().map(RuicRuntime::typesChanged).toArray(CompletableFuture<?>[]::new));
  }

  /** The end does not wait for those who plan something: what is planned after it is forgotten, not an error. */
  static ScheduledThreadPoolExecutor timer() {
    ScheduledThreadPoolExecutor timer = executor("robotui-timer");
    timer.setRejectedExecutionHandler(new ThreadPoolExecutor.DiscardPolicy());
    return timer;
  }

  private static ScheduledThreadPoolExecutor executor(String name) {
    ScheduledThreadPoolExecutor executor = new ScheduledThreadPoolExecutor(1, new SharedThreads(name));
    executor.setRemoveOnCancelPolicy(true);
    return executor;
  }

  @Override
  public void open(Surface surface, Principal principal) {
    stage = new Services.Stage(surface, principal);
  }

  @Override
  public List<Problem> load(Path file) {
    outside.begin(arbiters::stopAll, facts::lines, message -> events.alert("", message));
    configWatch.add(file);
    rereading.forgetEnded(file);
    return read(file).problems();
  }

  /** Somebody has changed a file. */
  private void reread(Path file) {
    events.configurationChanged(read(file));
  }

  private ConfigChange read(Path file) {
    List<Problem> more = new ArrayList<>();
    ConfigResult result = parts.configs().read(file, parts.registry());
    windows.put(file, result.windows());
    bridges.put(file, result.bridges());
    ConfigChange change = rereading.read(file, result, config -> {
      int before = more.size();
      add(file, config, more);
      return more.size() == before ? List.of(new ConfigChange.Step.Added(config.name())) : List.of();
    });
    events.ruicsChanged();
    ConfigChange all =
        new ConfigChange(file, Stream.concat(change.problems().stream(), more.stream()).toList(), change.steps());
    LOG.info("read {} with {} problems; robot UIs: {}", file, all.problems().size(),
        ruics.stream().map(RuicRuntime::name).toList());
    all.problems().forEach(problem -> LOG.info("{}", problem));
    return all;
  }

  private synchronized void add(Path file, RuicConfig config, List<Problem> problems) {
    OverlayStore store = overlays.computeIfAbsent(parts.state().overlay(file),
        path -> new OverlayStore(parts.overlays(), path, files, lost -> events.alert("", lost)));
    if (ruics.stream().anyMatch(r -> r.name().equals(config.name()))) {
      problems.add(new Problem(config.file(), config.line(), config.column(), Problem.Severity.ERROR,
          "a RUIC '" + config.name() + "' runs already; give this one another name, or remove the other first"));
      return;
    }
    RuicRuntime ruic = new RuicRuntime(config, store.of(config.name()), services);
    ruics.add(ruic);
    ruic.initialize();
  }

  @Override
  public CheckReport check(Path file, Duration wait) {
    return new Checker(parts).check(file, wait);
  }

  @Override
  public List<Installed> installed() {
    return parts.registry().installed();
  }

  @Override
  public ReuseReport reuse() {
    Reuse reuse = new Reuse(parts.registry(), parts.bundles());
    for (RuicRuntime ruic : ruics) {
      if (Plan.of(ruic.config(), parts.registry(), parts.check()) instanceof Plan.Outcome.Made made) {
        reuse.add(ruic.config(), made.plan());
      }
    }
    return reuse.report();
  }

  @Override
  public Optional<String> wrong(Setting setting, Object value) {
    return parts.check().value(setting, value) instanceof CheckedValue.Wrong w ? Optional.of(w.message())
        : Optional.empty();
  }

  @Override
  public List<Ruic> ruics() {
    return List.copyOf(ruics);
  }

  @Override
  public List<WindowConfig> windows() {
    synchronized (windows) {
      return windows.values().stream().flatMap(List::stream).toList();
    }
  }

  @Override
  public List<BridgeConfig> bridges() {
    synchronized (bridges) {
      return bridges.values().stream().flatMap(List::stream).toList();
    }
  }

  @Override
  public Composition compose(InterfaceConfig wanted) {
    return new Composing(wanted, services, parts.configs());
  }

  @Override
  public FileOpener files() {
    return opening;
  }

  @Override
  public PointedTime pointed() {
    return services.pointed();
  }

  @Override
  public ConfigSettings settings() {
    return settings;
  }

  @Override
  public Subscription listen(HostListener listener) {
    return notifier.listen(listener);
  }

  @Override
  public Subscription listen(HostListener listener, Executor executor) {
    return notifier.listen(listener, executor);
  }

  @Override
  public void displayAlive() {
    display.alive();
  }

  @Override
  public void displayFocused(boolean focused) {
    display.focus(focused);
    arbiters.recheckAll();
  }

  @Override
  public List<String> support(Path file) throws IOException {
    Optional<Path> home = Optional.ofNullable(System.getProperty("robotui.home")).map(Path::of);
    return new SupportFile(parts.state().path(), home).write(file, configWatch.files(),
        Map.of("process.txt", String.join("\n", facts.lines())));
  }

  @Override
  public Map<Path, String> configurationTexts() {
    return MaskedFiles.texts(configWatch.files());
  }

  @Override
  public void stopAll(Principal by) {
    arbiters.stopAll(by);
  }

  @Override
  public Duration closeLimit(Duration limit) {
    return time(limit).all();
  }

  private ClosingTime time(Duration limit) {
    return ClosingTime.of(limit, ruics.stream().mapToInt(RuicRuntime::running).sum());
  }

  @Override
  public List<String> close(Duration limit) {
    opening.close();
    ClosingTime time = time(limit);
    long end = System.nanoTime() + time.all().toNanos();
    List<RuicRuntime> all = List.copyOf(ruics);
    List<CompletableFuture<List<String>>> ends =
        all.stream().map(r -> r.shutDown(time.each()).toCompletableFuture()).toList();
    List<String> left = new ArrayList<>();
    for (int i = 0; i < all.size(); i++) {
      left.addAll(await(all.get(i), ends.get(i), end - System.nanoTime()));
    }
    overlays.values().forEach(OverlayStore::save);
    outside.close();
    arbiters.close();
    watch.close();
    timer.shutdownNow();
    files.shutdown(); // a look at files that is under way may end
    notifier.close();
    return List.copyOf(left);
  }

  private static List<String> await(RuicRuntime ruic, CompletableFuture<List<String>> end, long nanos) {
    try {
      return end.get(Math.max(1, nanos), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      return List.of(ruic.name() + " has not ended in time");
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return List.of(ruic.name() + ": closing was interrupted");
    } catch (ExecutionException e) {
      return List.of(ruic.name() + " has not ended: " + e.getCause());
    }
  }
}
