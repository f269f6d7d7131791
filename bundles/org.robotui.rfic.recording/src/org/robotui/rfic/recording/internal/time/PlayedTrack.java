package org.robotui.rfic.recording.internal.time;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.api.replay.Lane;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.TrackId;

/**
 * What the timeline has to know of an open recording. Times are those of the file. All is called on the thread of the
 * timeline, but for the plain facts, which any thread may ask for.
 */
public interface PlayedTrack {
  /**
   * Which it is.
   *
   * @return by its robot interface
   */
  TrackId id();

  /**
   * Where it is read.
   *
   * @return the file
   */
  Path file();

  /**
   * What tells it from other recordings, wherever the file lies.
   *
   * @return a word
   */
  String identity();

  /**
   * When it was recorded.
   *
   * @return from the first to the last message
   */
  TimeRange span();

  /**
   * Its topics, as far as they are known.
   *
   * @return sorted by name
   */
  List<Lane> lanes();

  /**
   * What could not be read so far.
   *
   * @return sentences
   */
  List<String> problems();

  /**
   * All of it, for who reads it as a whole.
   *
   * @return always the same
   */
  SearchableHistory history();

  /**
   * It was moved to a time: from now on nothing is delivered that was read for the time before. Does not wait for a
   * file.
   *
   * @param time where it is now
   */
  void moved(long time);

  /**
   * Time has passed.
   *
   * @param time where it is now
   */
  void passed(long time);

  /**
   * The nearest message after or before a time. May read the file.
   *
   * @param forward whether after it
   * @param time which is not looked at itself
   * @param topic of one topic; of any where there is none
   * @return its time; none where there is no such message
   */
  OptionalLong neighbour(boolean forward, long time, Optional<String> topic);
}
