package org.robotui.ros.internal.node;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.net.call.Outcome;
import org.robotui.ros.StaleRegistrations;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Goes through the records of a folder and removes what dead nodes left. */
public final class StaleRegistrationCleaner {

  private static final Logger LOG = LoggerFactory.getLogger(StaleRegistrationCleaner.class);
  private static final Duration PER_CALL = Duration.ofMillis(800);
  /** A master that is not found for so long is not found again under its old address. */
  private static final Duration KEPT = Duration.ofDays(7);

  private final Path folder;

  /** A sweep of a folder that need not exist. */
  public StaleRegistrationCleaner(Path folder) {
    this.folder = folder;
  }

  /** Looks at all records, as long as there is time. */
  public StaleRegistrations.Cleared run(Duration within) throws IOException {
    long deadline = System.nanoTime() + within.toNanos();
    List<String> nodes = new ArrayList<>();
    boolean complete = true;
    for (Path file : records()) {
      boolean late = System.nanoTime() >= deadline || Thread.currentThread().isInterrupted();
      Result result = late ? Result.OPEN : clear(file);
      complete &= !result.open();
      result.removed().ifPresent(nodes::add);
    }
    return new StaleRegistrations.Cleared(nodes, complete);
  }

  private List<Path> records() throws IOException {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.getFileName().toString().endsWith(NodeRecord.SUFFIX)).sorted().toList();
    }
  }

  /** What became of a record: the node that was removed, or whether it is to be tried again. */
  private record Result(Optional<String> removed, boolean open) {

    private static final Result NOTHING = new Result(Optional.empty(), false);
    private static final Result OPEN = new Result(Optional.empty(), true);
  }

  private static Result clear(Path file) {
    try {
      Optional<NodeRecord> record = read(file);
      return record.isPresent() ? clear(file, record.get()) : Result.NOTHING;
    } catch (IOException e) {
      LOG.warn("record {} cannot be removed: {}", file, e.toString());
      return Result.NOTHING;
    }
  }

  /** Records are written whole: one that cannot be read is damaged and of no use to anybody. */
  private static Optional<NodeRecord> read(Path file) throws IOException {
    try {
      return Optional.of(NodeRecord.read(file));
    } catch (NoSuchFileException e) {
      return Optional.empty();
    } catch (IOException e) {
      LOG.warn("record {} is damaged and is removed: {}", file, e.getMessage());
      Files.deleteIfExists(file);
      return Optional.empty();
    }
  }

  private static Result clear(Path file, NodeRecord record) throws IOException {
    LeftoverNode node = new LeftoverNode(record, PER_CALL);
    return node.mayRun() ? Result.NOTHING : clear(file, record, node.remove());
  }

  private static Result clear(Path file, NodeRecord record, Outcome<Integer> outcome) throws IOException {
    if (outcome instanceof Outcome.Done<Integer> done) {
      Files.deleteIfExists(file);
      LOG.info("{}: {} registrations of a process that ended were removed from {}", record.node(), done.value(),
          record.master());
      return done.value() > 0 ? new Result(Optional.of(record.node()), false) : Result.NOTHING;
    }
    LOG.debug("{} may have registrations left at {}: {}", record.node(), record.master(), outcome.reason());
    boolean old = Files.getLastModifiedTime(file).toInstant().isBefore(Instant.now().minus(KEPT));
    if (old) {
      Files.deleteIfExists(file);
    }
    return old ? Result.NOTHING : Result.OPEN;
  }
}
