package org.robotui.api.replay;

import java.io.IOException;

/**
 * Says how far two of the recordings that are open are apart, in the ways that their robots went or in a number: an
 * OSGi service, which is there while recordings can be played. Errors of ways are absolute and relative pose errors.
 * Safe for all threads.
 */
public interface RecordingComparison {
  /**
   * Reads what is compared of both recordings, and compares it. Blocks for the files: for a worker of who asks. Nothing
   * of it is kept.
   *
   * @param wish what is compared, and how
   * @return what it came to
   * @throws IllegalArgumentException where it cannot be compared so; the message says why and what could be done
   * @throws IOException where a file cannot be read any more, or a recording was closed meanwhile
   * @throws InterruptedException where the thread was interrupted
   */
  ComparisonReport compare(ComparisonWish wish) throws IOException, InterruptedException;
}
