package org.robotui.core.internal.compose;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.FileKind;
import org.robotui.api.RficType;
import org.robotui.api.UicType.Surface;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.host.FileOpener;
import org.robotui.api.host.FileOutcome;
import org.robotui.api.host.FileOutcome.NotOpened;
import org.robotui.api.host.FileOutcome.Opened;
import org.robotui.api.host.Problem;
import org.robotui.api.host.RuicView;
import org.robotui.core.internal.config.model.ConfigSource;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.life.Services;
import org.robotui.core.internal.life.SharedThreads;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Opens files as robots, one after another on a thread of its own. */
public final class FileOpening implements FileOpener, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(FileOpening.class);
  /** Bundles start within that, also on a slow machine. */
  private static final Duration TYPES = Duration.ofSeconds(5);

  private final Services services;
  private final ConfigSource configs;
  private final Function<Path, Path> places;
  private final Function<Path, List<Problem>> load;
  private final ExecutorService worker = Executors.newSingleThreadExecutor(new SharedThreads("robotui-open"));

  /**
   * Opens nothing yet.
   *
   * @param services of the host
   * @param configs reads configurations
   * @param places where the configuration of a file is kept
   * @param load reads a configuration and adds its RUICs
   */
  public FileOpening(Services services, ConfigSource configs, Function<Path, Path> places,
      Function<Path, List<Problem>> load) {
    this.services = services;
    this.configs = configs;
    this.places = places;
    this.load = load;
  }

  @Override
  public List<FileKind> kinds() {
    return types().flatMap(type -> type.files().stream()).toList();
  }

  private Stream<RficType> types() {
    return services.registry().rficIds().stream().flatMap(id -> services.registry().rfic(id).stream());
  }

  @Override
  public CompletionStage<FileOutcome> open(Path file) {
    try {
      return CompletableFuture.supplyAsync(() -> openNow(file), worker);
    } catch (RejectedExecutionException e) {
      return CompletableFuture.completedFuture(new NotOpened(file, file + " is not opened, as RobotUI ends"));
    }
  }

  private FileOutcome openNow(Path file) {
    FileOutcome outcome;
    try {
      outcome = obstacle(file).<FileOutcome>map(why -> new NotOpened(file, why)).orElseGet(() -> opened(file));
    } catch (RuntimeException e) {
      LOG.error("{} could not be opened", file, e);
      outcome = new NotOpened(file, file + " could not be opened: " + e);
    }
    LOG.info("{}", outcome);
    return outcome;
  }

  private static Optional<String> obstacle(Path file) {
    if (!Files.exists(file)) {
      return Optional.of("there is no file " + file);
    }
    if (!Files.isRegularFile(file) && !Files.isDirectory(file)) {
      return Optional.of(file + " is no plain file");
    }
    if (!Files.isReadable(file)) {
      return Optional.of(file + " may not be read: permission denied");
    }
    return file.toAbsolutePath().toString().contains("${")
        ? Optional.of(file + " has ${ in its path, which configurations take for a variable; rename it")
        : Optional.empty();
  }

  private FileOutcome opened(Path file) {
    Optional<FileMatch> match = awaitMatch(file);
    if (match.isEmpty()) {
      return new NotOpened(file, unknown(file));
    }
    Path configuration = place(match.get().place());
    Optional<String> failure =
        Files.exists(configuration) ? Optional.empty() : write(configuration, match.get());
    return failure.<FileOutcome>map(reason -> new NotOpened(file, reason)).orElseGet(() -> loaded(file, configuration));
  }

  /** Without views for a window another configuration is written than with them, which is not to be taken for it. */
  private Path place(Path file) {
    Path usual = places.apply(file);
    boolean window = services.stage().get().shows(Surface.WINDOW);
    return window ? usual : usual.resolveSibling("text-" + usual.getFileName());
  }

  /** Who opens a file, and what is opened then. */
  private record FileMatch(RficType type, Path place) {}

  private Optional<FileMatch> awaitMatch(Path file) {
    try {
      services.registry().await(() -> match(file).isPresent() && !services.registry().ruicIds().isEmpty(), TYPES);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return match(file);
  }

  private Optional<FileMatch> match(Path file) {
    return types().flatMap(type -> type.files().flatMap(kind -> kind.place(file))
        .map(place -> new FileMatch(type, place)).stream()).findFirst();
  }

  private String unknown(Path file) {
    String known = kinds().stream().flatMap(kind -> kind.extensions().stream()).map(e -> "." + e).distinct().sorted()
        .collect(Collectors.joining(", "));
    String folders = kinds().stream().flatMap(kind -> kind.folders().stream()).distinct()
        .collect(Collectors.joining(" or "));
    return "no robot interface that is installed opens " + (Files.isDirectory(file) ? "the folder " : "") + file + "; "
        + (known.isEmpty() ? "none of them opens files" : "files that are opened end with " + known)
        + (folders.isEmpty() ? "" : ", folders with " + folders + " in them")
        + ", and configurations with .yaml";
  }

  private Optional<String> write(Path configuration, FileMatch match) {
    try {
      Files.createDirectories(configuration.getParent());
    } catch (IOException e) {
      return Optional.of(configuration + " cannot be written: " + WriteFailure.reason(e));
    }
    Path file = match.place().toAbsolutePath().normalize();
    String ending = Files.isDirectory(file) ? ""
        : match.type().files().flatMap(kind -> kind.extension(file.getFileName().toString())).map(e -> "." + e)
            .orElse("");
    FileTrial trial = new FileTrial(services, configs, match.type(), file, ending);
    try {
      return trial.write(configuration);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.of(file + " is not opened, as RobotUI ends");
    }
  }

  /** A file whose RUICs run already is opened, too. */
  private FileOutcome loaded(Path file, Path configuration) {
    List<Problem> problems = load.apply(configuration);
    List<String> running = services.ruics().get().stream().map(RuicView::name).toList();
    List<String> names = configs.read(configuration, services.registry()).ruics().stream().map(RuicConfig::name)
        .filter(running::contains).toList();
    Optional<Problem> error = problems.stream().filter(p -> p.severity() == Problem.Severity.ERROR).findFirst();
    return error.isPresent() ? new NotOpened(file, file + " is not shown: " + error.get())
        : new Opened(file, configuration, names, problems);
  }

  /** What is being opened is left as it is. */
  @Override
  public void close() {
    worker.shutdownNow();
  }
}
