package org.robotui.workbench.internal;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.Host;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;
import org.robotui.workbench.internal.display.Overviewer;
import org.robotui.workbench.internal.dock.ArrangeHistory;
import org.robotui.workbench.internal.keys.KeyStore;
import org.robotui.workbench.internal.keys.KeysFile;
import org.robotui.workbench.internal.model.Alerts;
import org.robotui.workbench.internal.model.Overview;
import org.robotui.workbench.internal.model.RecentFiles;
import org.robotui.workbench.internal.model.Stops;
import org.robotui.workbench.internal.model.WindowModel;
import org.robotui.workbench.internal.model.Windows;
import org.robotui.workbench.internal.pane.ExchangeDialog;
import org.robotui.workbench.internal.timeline.EventSearch;
import org.robotui.workbench.internal.timeline.LiveTimeline;
import org.robotui.workbench.internal.timeline.PictureSaving;
import org.robotui.workbench.internal.timeline.RecordingCalls;
import org.robotui.workbench.internal.timeline.RunCompare;
import org.robotui.workbench.internal.timeline.TrackAnalysis;

/** What all windows of one run of the workbench share. Display thread only. */
public final class WorkbenchSession {
  private static final int REFRESH_MILLIS = 250;

  private final Host host;
  private final Principal user;
  private final Display display;
  private final Arguments arguments;
  private final UserState state;
  private final ActiveTheme look;
  private final Subscription following;
  private final Overviewer overviewer;
  private final Windows windows;
  private final Map<Object, WindowModel> models = new HashMap<>();
  private final Map<String, ArrangeHistory> histories = new HashMap<>();
  private final Map<String, ExchangeDialog> exchanges = new HashMap<>();
  private final List<Runnable> refreshers = new CopyOnWriteArrayList<>();
  private final List<Runnable> loaders = new CopyOnWriteArrayList<>();
  private final Map<String, WindowModel> awaited = new HashMap<>();
  private final Configurations configurations;
  private final RecentFiles recent;
  private final Alerts alerts = new Alerts(System::nanoTime);
  private final KeyStore keys;
  private final LiveTimeline timeline = new LiveTimeline(this::later);
  private final EventSearch search = new EventSearch(this::later,
      task -> Thread.ofPlatform().daemon().name("robotui-find").start(task), WorkbenchServices::search);
  private final RecordingCalls calls =
      new RecordingCalls(this::later, task -> Thread.ofPlatform().daemon().name("robotui-recordings").start(task));
  private final RunCompare compare = new RunCompare(calls, WorkbenchServices::comparison);
  private final PictureSaving pictures = new PictureSaving(calls, timeline, WorkbenchServices::videos);
  private final TrackAnalysis analysis =
      new TrackAnalysis(calls, WorkbenchServices::offsets, WorkbenchServices::reports,
          WorkbenchServices::videos);

  /**
   * Starts to follow the core.
   *
   * @param host the core, open already
   * @param user as whom the user acts
   * @param display the display
   * @param arguments what the command line asks
   * @param state what was kept
   * @param look the theme
   * @param components done when the types of components are known, without which no configuration is read
   */
  public WorkbenchSession(Host host, Principal user, Display display, Arguments arguments, UserState state,
      ActiveTheme look, CompletableFuture<?> components) {
    this.host = host;
    this.user = user;
    this.display = display;
    this.arguments = arguments;
    this.state = state;
    recent = new RecentFiles(state);
    this.look = look;
    keys = new KeyStore(new KeysFile(state.folder().resolve("keys.yaml")), damage -> alerts.tell("", damage));
    windows = new Windows(host);
    overviewer = new Overviewer(host, this::later, this::showAll);
    configurations = new Configurations(host, this::later, this::loaded, components);
    following = listen(new HostListener() {
      @Override
      public void ruicsChanged() {
        windows.ruicsChanged();
        showAwaited();
        refresh();
      }

      @Override
      public void showWanted(String from, String wanted) {
        ruic(wanted).ifPresent(r -> windows.showInstead(from, r));
        refresh();
      }

      @Override
      public void alert(String ruic, String message) {
        alerts.tell(ruic, message);
      }

      @Override
      public void notice(String message) {
        alerts.pass(message);
      }

      @Override
      public void configurationChanged(ConfigChange change) {
        configurations.changed(change.file(), ConfigNews.problems(change, WorkbenchSession.this::isShown));
        Optional.of(ConfigNews.notice(change)).filter(words -> !words.isEmpty()).ifPresent(alerts::pass);
      }
    });
    display.timerExec(REFRESH_MILLIS, this::periodic);
  }

  /** The core. */
  public Host host() {
    return host;
  }

  /** As whom the user acts. */
  public Principal user() {
    return user;
  }

  /** What the command line asks. */
  public Arguments arguments() {
    return arguments;
  }

  /** What is kept from run to run. */
  public UserState state() {
    return state;
  }

  /** Which keys run which commands. */
  public KeyStore keys() {
    return keys;
  }

  /** The recordings that are open. */
  public LiveTimeline timeline() {
    return timeline;
  }

  /** What is searched for in recordings. */
  public EventSearch search() {
    return search;
  }

  /** What recordings are compared to. */
  public RunCompare compare() {
    return compare;
  }

  /** Saves what views show of recordings. */
  public PictureSaving pictures() {
    return pictures;
  }

  /** What takes long and is asked of recordings. */
  public TrackAnalysis analysis() {
    return analysis;
  }

  /** The theme. */
  public ActiveTheme look() {
    return look;
  }

  /** Tells a listener what core tells, on the display thread, until the result is closed. */
  public Subscription listen(HostListener listener) {
    return host.listen(listener, this::later);
  }

  /** What the windows show. */
  public Windows windows() {
    return windows;
  }

  /** What was opened last. */
  public RecentFiles recent() {
    return recent;
  }

  /** Reads configurations. */
  public Configurations configurations() {
    return configurations;
  }

  /** How the views of a RUIC were arranged before, for undo. */
  public ArrangeHistory history(Ruic ruic) {
    return histories.computeIfAbsent(ruic.name(), name -> new ArrangeHistory());
  }

  /** What went wrong last. */
  public Alerts alerts() {
    return alerts;
  }

  /** What a window of the platform shows. */
  public WindowModel model(Object window) {
    return models.computeIfAbsent(window, w -> windows.open());
  }

  /** A window of the platform has closed. */
  public void closed(Object window) {
    Optional.ofNullable(models.remove(window)).ifPresent(windows::close);
  }

  /** Shows a RUIC in a window as soon as it is there. */
  public void showWhenThere(WindowModel model, String name) {
    awaited.put(name, model);
    showAwaited();
  }

  private void showAwaited() {
    List.copyOf(awaited.keySet()).forEach(name -> ruic(name).ifPresent(r -> {
      WindowModel model = awaited.remove(name);
      if (models.containsValue(model)) {
        windows.select(model, r);
      }
    }));
  }

  private boolean isShown(String ruic) {
    return models.values().stream().anyMatch(m -> m.selected().filter(r -> r.name().equals(ruic)).isPresent());
  }

  /** The window in which a RUIC's framework is changed, where it is open; at most one per RUIC. */
  public Map<String, ExchangeDialog> exchanges() {
    exchanges.values().removeIf(ExchangeDialog::isClosed);
    return exchanges;
  }

  /** Finds a RUIC. */
  public Optional<Ruic> ruic(String name) {
    return host.ruics().stream().filter(r -> r.name().equals(name)).findFirst();
  }

  /** Has something run four times a second, and when RUICs or selections change. Running the result ends that. */
  public Runnable onRefresh(Runnable refresher) {
    refreshers.add(refresher);
    return () -> refreshers.remove(refresher);
  }

  /** Has something run after each configuration that was read, when its robots are shown. */
  public void onLoaded(Runnable task) {
    loaders.add(task);
  }

  /** Shows what is known, and soon what is true now. */
  public void refresh() {
    showAll();
    survey();
  }

  /** How the robots were doing a moment ago. */
  public Overview overview() {
    return overviewer.last();
  }

  /** Stops all robots. */
  public void stop() {
    host.stopAll(user);
    refresh();
  }

  /** Releases the stop of all robots. */
  public void release() {
    release(authorities());
  }

  /** Releases the stop of some robots. */
  public void release(List<Authority> robots) {
    robots.stream().filter(a -> a.stoppedBy().isPresent()).forEach(a -> a.releaseStop(user));
    refresh();
  }

  /** Stops some robots. */
  public void stop(List<Authority> robots) {
    robots.forEach(a -> a.stop(user));
    refresh();
  }

  /** Which robots are stopped. */
  public Stops stops() {
    return Stops.of(authorities());
  }

  /** Ends following the core. */
  public void close() {
    following.close();
    overviewer.close();
    configurations.close();
  }

  private List<Authority> authorities() {
    return host.ruics().stream().flatMap(r -> r.authorities().stream()).toList();
  }

  private void loaded(Path file, List<Problem> problems) {
    if (problems.stream().noneMatch(p -> p.severity() == Problem.Severity.ERROR)) {
      recent.add(file);
    }
    windows.ruicsChanged();
    models.values().stream().filter(m -> m.selected().isEmpty()).findFirst().ifPresent(windows::fill);
    refresh();
    loaders.forEach(Runnable::run);
  }

  /** A bundle has come or gone that nobody in a window asked for. Any thread. */
  void installed(String sentence, boolean trouble) {
    later(() -> {
      if (trouble) {
        alerts.tell("", sentence);
      } else {
        alerts.pass(sentence);
      }
      refresh();
    });
  }

  /** Runs a task on the display thread, later. */
  void later(Runnable task) {
    if (!display.isDisposed()) {
      display.asyncExec(task);
    }
  }

  private void showAll() {
    refreshers.forEach(Runnable::run);
  }

  private void survey() {
    overviewer.request(
        models.values().stream().flatMap(m -> m.selected().stream()).map(Ruic::name).collect(Collectors.toSet()));
  }

  private void periodic() {
    survey();
    display.timerExec(REFRESH_MILLIS, this::periodic);
  }
}
