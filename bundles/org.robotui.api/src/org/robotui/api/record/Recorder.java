package org.robotui.api.record;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.robotui.api.host.Host.Subscription;

/**
 * Records what robots send, whatever their frameworks, as MCAP: an OSGi service. There is one recording at a time, and
 * beside it the last seconds may be kept in memory. A robot is asked only for what is recorded. Safe for all threads;
 * methods that say so read or write files, and are not for the display thread.
 */
public interface Recorder {
  /**
   * What stands against a recording: no such folder, no right to write, too little room. Looks at the disk.
   *
   * @param plan how it would be made
   * @return a sentence for users, or nothing
   */
  Optional<String> obstacle(RecordingPlan plan);

  /**
   * Begins a recording. Streams that are offered later are taken as they come. Creates the file.
   *
   * @param plan how it is made
   * @return the first file, or why there is none
   */
  RecordingOutcome start(RecordingPlan plan);

  /**
   * Ends the recording; waits until its files are whole.
   *
   * @return the files, or that nothing was recorded
   */
  RecordingOutcome stop();

  /**
   * Keeps the last seconds from now on, in place of what was kept before. What would take too much memory goes earlier.
   *
   * @param limit how long, 1 s to 10 minutes
   * @param choice what is kept
   * @return that it is so, or why not
   */
  RecordingOutcome keepRecent(Duration limit, RecordingChoice choice);

  /** Keeps the last seconds no more. */
  void forgetRecent();

  /**
   * Writes what is kept of the last seconds; it is kept on. Writes the file.
   *
   * @param target the file, which must not be there yet; or a folder that is there, in which a file is named by the
   * time
   * @return the file, or why there is none
   */
  RecordingOutcome saveRecent(Path target);

  /**
   * What it does now. Cheap enough to ask for ten times a second.
   *
   * @return its state
   */
  RecorderState state();

  /**
   * Tells when a recording begins or ends, a file of it is begun, and what is wrong with it changes; counts are asked
   * for by {@link #state}.
   *
   * @param listener is called on a thread of the recorder; must not block
   * @return ends the subscription when closed
   */
  Subscription listen(Runnable listener);
}
