package org.robotui.api.time;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;

/**
 * The time at which a user points, for example with the mouse in a plot, so that all that show something over time can
 * say what was then. There is one for all views and windows of an application; nothing says which view points. Times
 * are nanoseconds since 1970: of recordings those of the timeline, of live robots those of their values. Safe for all
 * threads.
 */
public final class PointedTime {
  private final AtomicReference<Optional<Pointing>> now = new AtomicReference<>(Optional.empty());
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();

  private record Pointing(Object by, long time) {}

  /** Nobody points anywhere. */
  public PointedTime() {
    // begins without a time
  }

  /**
   * Points at a time, in place of whoever pointed before.
   *
   * @param by who points, told apart by identity; takes back by {@link #leave}
   * @param time nanoseconds since 1970
   */
  public void point(Object by, long time) {
    Optional<Pointing> before = now.getAndSet(Optional.of(new Pointing(by, time)));
    if (before.filter(each -> each.by() == by && each.time() == time).isEmpty()) {
      listeners.forEach(Runnable::run);
    }
  }

  /**
   * Points at nothing any more; does nothing where somebody else points meanwhile.
   *
   * @param by who pointed
   */
  public void leave(Object by) {
    Optional<Pointing> before = now.getAndUpdate(each -> each.filter(pointing -> pointing.by() != by));
    if (before.filter(pointing -> pointing.by() == by).isPresent()) {
      listeners.forEach(Runnable::run);
    }
  }

  /**
   * At which time the user points elsewhere.
   *
   * @param viewer who asks
   * @return the time; none where nobody points, or the viewer itself
   */
  public OptionalLong elsewhere(Object viewer) {
    return now.get().filter(pointing -> pointing.by() != viewer).map(pointing -> OptionalLong.of(pointing.time()))
        .orElse(OptionalLong.empty());
  }

  /**
   * Tells of changes, for those who do not look regularly.
   *
   * @param changed is called on the thread of who points; must not block
   * @return ends that when run
   */
  public Runnable listen(Runnable changed) {
    listeners.add(changed);
    return () -> listeners.remove(changed);
  }
}
