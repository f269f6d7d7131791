package org.robotui.workbench.internal.timeline;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.robotui.api.replay.FoundEvent;
import org.robotui.api.replay.RecordingSearch;
import org.robotui.api.replay.SearchTaker;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The search in recordings that all windows share. It runs on a thread of its own; what it finds is taken up on the
 * display thread, once for any number of events that wait. Display thread, but for what the thread of a search calls.
 */
public final class EventSearch {
  private static final Logger LOG = LoggerFactory.getLogger(EventSearch.class);
  /** More events than anybody looks through, and few enough to be painted. */
  static final int MOST = 5_000;
  private static final String NOT_THERE =
      "there is nothing that searches recordings; install the feature 'RobotUI recordings'";

  private final Executor display;
  private final Executor workers;
  private final Supplier<Optional<RecordingSearch>> service;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private final List<Runnable> askers = new CopyOnWriteArrayList<>();
  private Optional<Run> running = Optional.empty();
  private FoundEvents state = FoundEvents.NONE;

  /**
   * Has searched for nothing yet.
   *
   * @param display runs tasks on the display thread, later and one after another
   * @param workers runs each task on a thread of its own
   * @param service searches, where it is there
   */
  public EventSearch(Executor display, Executor workers, Supplier<Optional<RecordingSearch>> service) {
    this.display = display;
    this.workers = workers;
    this.service = service;
  }

  /** Has something run after each change; running the result ends that. */
  Runnable onChange(Runnable listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  /** Has something run when a user wants to search; running the result ends that. */
  Runnable onAsk(Runnable asker) {
    askers.add(asker);
    return () -> askers.remove(asker);
  }

  /** A user wants to search. */
  public void ask() {
    askers.forEach(Runnable::run);
  }

  FoundEvents state() {
    return state;
  }

  /** What is wrong with a condition; empty where it can be searched for, or nobody can tell. */
  Optional<String> fault(String condition) {
    return service.get().flatMap(search -> search.fault(condition));
  }

  /** Searches in all recordings, in place of the search before. */
  void start(String condition) {
    stop();
    Optional<RecordingSearch> search = service.get();
    show(search.isPresent() ? FoundEvents.begun(condition) : FoundEvents.begun(condition).failed(NOT_THERE));
    search.ifPresent(found -> {
      Run run = new Run(found, condition);
      running = Optional.of(run);
      workers.execute(run);
    });
  }

  /** Ends the search that runs; what it has found stays. */
  void stop() {
    running.ifPresent(Run::stop);
    running = Optional.empty();
    if (state.running()) {
      show(state.ended(List.of()));
    }
  }

  /** Forgets what was found. */
  void clear() {
    stop();
    show(FoundEvents.NONE);
  }

  private void show(FoundEvents next) {
    state = next;
    listeners.forEach(Runnable::run);
  }

  /** One search. */
  private final class Run implements Runnable, SearchTaker {
    private final RecordingSearch search;
    private final String condition;
    private final List<FoundEvent> events = new ArrayList<>();
    private long more;
    private double share;
    private boolean waiting;
    private volatile boolean wanted = true;

    private Run(RecordingSearch search, String condition) {
      this.search = search;
      this.condition = condition;
    }

    private void stop() {
      wanted = false;
    }

    @Override
    public void run() {
      try {
        List<String> problems = search.search(condition, this).problems();
        end(now -> now.ended(problems));
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      } catch (IOException | IllegalArgumentException e) {
        end(now -> now.failed(String.valueOf(e.getMessage())));
      } catch (RuntimeException e) {
        LOG.error("the search for '{}' failed", condition, e);
        end(now -> now.failed("the search failed: " + e));
      }
    }

    @Override
    public synchronized void found(FoundEvent event) {
      if (events.size() < MOST) {
        events.add(event);
      } else {
        more++;
      }
      tell();
    }

    @Override
    public synchronized boolean reached(double now) {
      share = now;
      tell();
      return wanted;
    }

    private void tell() {
      if (!waiting) {
        waiting = true;
        display.execute(() -> take(now -> now));
      }
    }

    private void end(UnaryOperator<FoundEvents> last) {
      display.execute(() -> {
        take(last);
        running = running.filter(each -> each != this);
      });
    }

    /** On the display thread: what was stopped is not looked at any more. */
    private void take(UnaryOperator<FoundEvents> change) {
      FoundEvents now;
      synchronized (this) {
        waiting = false;
        now = state.at(share, events, more);
      }
      if (wanted) {
        show(change.apply(now));
      }
    }
  }
}
