package org.robotui.api;

import java.util.Optional;
import org.robotui.api.show.Subject;

/** One view or control of a RUIC. */
public interface Uic extends AutoCloseable {
  /**
   * Takes the newest data from the inputs and prepares what is to be shown. Called on this instance's own worker
   * thread, at most at the rate of its type, only while its RUIC is selected. One that throws or does not return within
   * two seconds is fenced: the instance fails, the others go on. The first one has ten seconds, since its classes may
   * have to be loaded.
   *
   * @param nowNanos {@link System#nanoTime()}
   * @return true where there is something new to show
   */
  boolean tick(long nowNanos);

  /**
   * Shows something that the user pointed at in another view. The application calls it when the view is in front, on
   * the thread of its surface: in a window on the display thread, after {@code createControl}. It must not block.
   *
   * @param showing the id of one of the showings of its type
   * @param subject what to show, of a kind and a type that the showing takes; it may have gone since
   */
  default void show(String showing, Subject subject) {
    // Only views whose type declares showings are asked.
  }

  /**
   * What a new instance shall go on with, such as a history that the robot will not send again. Asked at most once, on
   * a core worker after {@link #close}, and only where this instance was ended because it was late and its thread has
   * ended. The new one takes it from {@link UicContext#retained}. What it holds of this instance's context must not be
   * used any more.
   *
   * @return an object of the view's own; nothing where a new instance begins anew
   */
  default Optional<Object> retain() {
    return Optional.empty();
  }

  /**
   * Releases what it holds. Called once on a core worker, after the last tick. Its surface may still be seen for a
   * moment, until the application has heard of the end, and must bear that.
   */
  @Override
  void close();
}
