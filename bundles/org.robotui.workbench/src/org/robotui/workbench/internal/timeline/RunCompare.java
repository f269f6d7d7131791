package org.robotui.workbench.internal.timeline;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import org.robotui.api.replay.ComparisonReport;
import org.robotui.api.replay.ComparisonWish;
import org.robotui.api.replay.RecordingComparison;
import org.robotui.ui.Health;

/**
 * What two recordings are compared to, which all windows share. It is read on a thread of its own, and taken up on the
 * display thread. Display thread.
 */
public final class RunCompare {
  private static final String NOT_THERE =
      "there is nothing that compares recordings; install the feature 'RobotUI recordings'";

  private final RecordingCalls calls;
  private final Supplier<Optional<RecordingComparison>> service;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private Standing standing = new Standing(false, Optional.empty(), Optional.empty(), "");

  /**
   * How it stands.
   *
   * @param running whether files are read
   * @param wish what was asked for last
   * @param report what it came to
   * @param failure why there is no answer; empty where nothing failed
   */
  record Standing(boolean running, Optional<ComparisonWish> wish, Optional<ComparisonReport> report, String failure) {
    /** In a line, for users. */
    String words() {
      if (!failure.isEmpty()) {
        return failure;
      }
      return running ? "reading both recordings\u2026"
          : report.map(each -> each.pairs() + " pairs of " + each.first() + " and " + each.second() + " values"
              + (each.problems().isEmpty() ? "" : "; " + String.join("; ", each.problems()))).orElse("");
    }

    Health health() {
      return !failure.isEmpty() ? Health.BAD
          : report.filter(each -> !each.problems().isEmpty()).isPresent() ? Health.WARNING : Health.NONE;
    }
  }

  /**
   * Has compared nothing yet.
   *
   * @param calls runs what is asked for
   * @param service compares, where it is there
   */
  public RunCompare(RecordingCalls calls, Supplier<Optional<RecordingComparison>> service) {
    this.calls = calls;
    this.service = service;
  }

  /** Has something run after each change; running the result ends that. */
  Runnable onChange(Runnable listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  Standing standing() {
    return standing;
  }

  /** Compares, in place of what was compared before. */
  void start(ComparisonWish wish) {
    Optional<RecordingComparison> comparison = service.get();
    Optional<ComparisonWish> asked = Optional.of(wish);
    show(comparison.isPresent() ? new Standing(true, asked, Optional.empty(), "")
        : new Standing(false, asked, Optional.empty(), NOT_THERE));
    comparison.ifPresent(found -> calls.start(() -> found.compare(wish), answer -> take(wish, answer)));
  }

  /** Writes all errors to a file. */
  void save(Path file) {
    standing.report().ifPresent(report -> calls.start(() -> RecordingCalls.write(file, report.csv()), answer -> {
      if (answer instanceof RecordingCalls.Answer.Failed<Path> failed) {
        show(new Standing(standing.running(), standing.wish(), standing.report(), failed.why()));
      }
    }));
  }

  /** Of several that were asked for, the last one counts. */
  private void take(ComparisonWish wish, RecordingCalls.Answer<ComparisonReport> answer) {
    if (standing.wish().filter(wish::equals).isPresent()) {
      show(switch (answer) {
        case RecordingCalls.Answer.Given<ComparisonReport> given -> new Standing(false, Optional.of(wish),
            Optional.of(given.value()), "");
        case RecordingCalls.Answer.Failed<ComparisonReport> failed -> new Standing(false, Optional.of(wish),
            Optional.empty(), failed.why());
      });
    }
  }

  private void show(Standing next) {
    standing = next;
    listeners.forEach(Runnable::run);
  }
}
