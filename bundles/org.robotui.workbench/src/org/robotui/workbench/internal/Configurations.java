package org.robotui.workbench.internal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.robotui.api.host.FileOutcome;
import org.robotui.api.host.Host;
import org.robotui.api.host.Problem;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Reads configurations off the display thread and keeps what is wrong with them. Display thread only. */
public final class Configurations implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Configurations.class);

  private final Host host;
  private final Executor display;
  private final BiConsumer<Path, List<Problem>> loaded;
  private final Map<Path, List<Problem>> problems = new LinkedHashMap<>();
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private final ExecutorService worker = Executors.newSingleThreadExecutor(
      Thread.ofPlatform().daemon().name("robotui-load").factory());
  private final Set<Path> files = new LinkedHashSet<>();
  private final Map<Path, Consumer<FileOutcome>> opening = new HashMap<>();
  private final Map<String, Path> opened = new HashMap<>();
  private int reading;

  /**
   * Reads nothing yet.
   *
   * @param host the core
   * @param display runs tasks on the display thread
   * @param loaded is told on the display thread after each file
   * @param components what the first reading waits for: a type that is not known yet would be a problem
   */
  public Configurations(Host host, Executor display, BiConsumer<Path, List<Problem>> loaded,
      CompletableFuture<?> components) {
    this.host = host;
    this.display = display;
    this.loaded = loaded;
    worker.execute(components::join);
  }

  /** Reads a file and adds its RUICs. */
  public void load(Path file) {
    reading++;
    files.add(file);
    worker.execute(() -> {
      List<Problem> found = read(file);
      display.execute(() -> done(file, found));
    });
  }

  /** Opens a file such as a recording as a robot; {@code done} is told on the display thread what came of it. */
  public void open(Path file, Consumer<FileOutcome> done) {
    reading++;
    opening.put(file, done);
    worker.execute(() -> host.files().open(file).thenAccept(outcome -> display.execute(() -> opened(outcome))));
  }

  private void opened(FileOutcome outcome) {
    List<Problem> found = switch (outcome) {
      case FileOutcome.Opened o -> o.problems();
      case FileOutcome.NotOpened n -> List
          .of(new Problem(n.file().toString(), 0, 0, Problem.Severity.ERROR, withoutName(n)));
    };
    if (outcome instanceof FileOutcome.Opened o) {
      o.ruics().forEach(name -> opened.put(name, o.file()));
    }
    done(outcome.file(), found);
    opening.get(outcome.file()).accept(outcome);
  }

  /** The file is named beside the problem already. */
  private static String withoutName(FileOutcome.NotOpened refused) {
    String name = refused.file() + " ";
    return refused.reason().startsWith(name) ? refused.reason().substring(name.length()) : refused.reason();
  }

  /** The file as which a RUIC was opened, where it was not loaded by a configuration that somebody wrote. */
  public Optional<Path> openedAs(String ruic) {
    return Optional.ofNullable(opened.get(ruic));
  }

  /** All files that were read, in their order, as they were named. */
  public List<Path> files() {
    return List.copyOf(files);
  }

  /** Runs what reads and writes files, off the display thread and one after the other. */
  public Executor background() {
    return worker;
  }

  /** Whether the display knows the outcome of all that was to be read. */
  public boolean areRead() {
    return reading == 0;
  }

  /** What is wrong, in the order of the files. */
  public List<Problem> problems() {
    List<Problem> all = new ArrayList<>();
    problems.values().forEach(all::addAll);
    return all;
  }

  /** Reads the files again that have problems. */
  public void reload() {
    List.copyOf(problems.keySet()).forEach(
        file -> Optional.ofNullable(opening.get(file)).ifPresentOrElse(done -> open(file, done), () -> load(file)));
  }

  /** A file was changed by somebody: what is wrong with it now. */
  public void changed(Path file, List<Problem> found) {
    keep(file, found);
    listeners.forEach(Runnable::run);
  }

  /** Forgets the problems. */
  public void forget() {
    problems.clear();
    listeners.forEach(Runnable::run);
  }

  /** Has something run when the problems change; running the result ends that. */
  public Runnable onChange(Runnable listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  @Override
  public void close() {
    worker.shutdownNow();
  }

  private List<Problem> read(Path file) {
    try {
      return host.load(file);
    } catch (RuntimeException e) {
      LOG.error("{} could not be loaded", file, e);
      return List.of(new Problem(file.toString(), 0, 0, Problem.Severity.ERROR, "it could not be loaded: " + e));
    }
  }

  private void done(Path file, List<Problem> found) {
    reading--;
    keep(file, found);
    loaded.accept(file, found);
    listeners.forEach(Runnable::run);
  }

  private void keep(Path file, List<Problem> found) {
    if (found.isEmpty()) {
      problems.remove(file);
    } else {
      problems.put(file, found);
    }
  }
}
