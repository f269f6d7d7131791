package org.robotui.api;

/** One view or control of a RUIC. */
public interface Uic extends AutoCloseable {
  /**
   * Takes the newest data from the inputs and prepares what is to be shown. Called on this instance's own worker thread, at
   * most at the rate of its type, only while its RUIC is selected. One that throws or does not return within two seconds is
   * fenced: the instance fails, the others go on. The first one has ten seconds, since its classes may have to be loaded.
   *
   * @param nowNanos {@link System#nanoTime()}
   * @return true where there is something new to show
   */
  boolean tick(long nowNanos);

  /**
   * Releases what it holds. Called once on a core worker, after the last tick. Its surface may still be seen for a moment,
   * until the application has heard of the end, and must bear that.
   */
  @Override
  void close();
}
