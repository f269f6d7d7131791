package org.robotui.roboframe.app;

import java.util.ArrayDeque;
import java.util.Optional;
import org.robotui.roboframe.board.Posted;

/**
 * What has come of a key for one module. Of a key of which every value counts, 256 wait at most, and then the oldest
 * go; of others the newest only. Safe for all threads.
 *
 * @param <T> its values
 */
public final class KeyInput<T> {

  private static final int MOST = 256;

  private final int most;
  private final Runnable wake;
  private final ArrayDeque<Posted<T>> waiting = new ArrayDeque<>(); // guarded by this, as the following
  private Optional<Posted<T>> newest = Optional.empty();
  private long dropped;

  KeyInput(boolean every, Runnable wake) {
    this.most = every ? MOST : 1;
    this.wake = wake;
  }

  void accept(Posted<T> value) {
    synchronized (this) {
      if (waiting.size() >= most) {
        waiting.remove();
        dropped++;
      }
      waiting.add(value);
      newest = Optional.of(value);
    }
    wake.run();
  }

  /**
   * The newest value, also when it was taken already.
   *
   * @return none where nothing has come
   */
  public synchronized Optional<Posted<T>> newest() {
    return newest;
  }

  /**
   * The next value that was not taken yet.
   *
   * @return none where nothing new has come
   */
  public synchronized Optional<Posted<T>> take() {
    return Optional.ofNullable(waiting.poll());
  }

  /**
   * Values that gave way to newer ones before they were taken.
   *
   * @return how many so far
   */
  public synchronized long dropped() {
    return dropped;
  }
}
