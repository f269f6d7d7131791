package org.robotui.api.replay;

import java.util.List;
import java.util.Optional;

/**
 * How the timeline stands.
 *
 * @param span from the start of the earliest recording to the end of the latest; none where no recording is open
 * @param position where it is, nanoseconds since 1970, within the span; 0 where no recording is open
 * @param playing whether time goes on
 * @param speed how many seconds of the recordings pass in one second while it plays, {@link Timeline#SLOWEST} to
 * {@link Timeline#FASTEST}
 * @param looping whether it begins again at the end
 * @param range the part that is played; none for all of the span
 * @param bookmarks by time
 * @param lagging whether playing is slower than the speed says, as messages cannot be read or shown as fast
 */
public record TimelineState(Optional<TimeRange> span, long position, boolean playing, double speed, boolean looping,
    Optional<TimeRange> range, List<Bookmark> bookmarks, boolean lagging) {

  /** No recording is open. */
  public static final TimelineState EMPTY =
      new TimelineState(Optional.empty(), 0, false, 1, false, Optional.empty(), List.of(), false);

  /**
   * Copies the list.
   *
   * @param span of all recordings
   * @param position where it is
   * @param playing whether time goes on
   * @param speed of playing
   * @param looping whether it begins again
   * @param range the part that is played
   * @param bookmarks by time
   * @param lagging whether it is slower than wanted
   */
  public TimelineState {
    bookmarks = List.copyOf(bookmarks);
  }
}
