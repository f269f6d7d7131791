package org.robotui.api.replay;

import java.util.List;
import java.util.Optional;
import org.robotui.api.host.Host.Subscription;

/**
 * The one time of all recordings that are open: an OSGi service, which is there while recordings can be played. All
 * recordings are moved together. At any position views show what they would have shown live at that time: the last
 * value before it of each topic, then what follows while it plays. Methods return at once, do nothing where no
 * recording is open, and are safe for all threads. Times are nanoseconds since 1970, those of a file with the offset of
 * its track.
 */
public interface Timeline {
  /** The slowest speed. */
  double SLOWEST = 0.01;
  /** The fastest speed. */
  double FASTEST = 100;

  /**
   * How it stands.
   *
   * @return now; the position is that of this moment
   */
  TimelineState state();

  /**
   * The recordings that are open.
   *
   * @return sorted by robot and instance
   */
  List<Track> tracks();

  /** Plays from the position on; from the start of what is played where it stands at the end of it. */
  void play();

  /** Stands still, with all values kept. */
  void pause();

  /**
   * Goes to a time; playing goes on where it plays.
   *
   * @param time nanoseconds since 1970; the nearest time of the span is taken
   */
  void seek(long time);

  /**
   * Pauses, and goes on to a later time as playing does: all that lies before it is delivered, and nothing jumps. Goes
   * to an earlier one as {@link #seek} does.
   *
   * @param time nanoseconds since 1970; the nearest time of the span is taken
   */
  void advance(long time);

  /**
   * Whether it stands where it was wanted last, and all that holds there was given to the views.
   *
   * @return false while it is being moved, or while values before the position are still read; true where no recording
   * is open
   */
  boolean isThere();

  /**
   * Pauses, and goes to the next or to the former message.
   *
   * @param forward whether to the next
   * @param lane of one topic of one recording; of any of them where there is none
   */
  void step(boolean forward, Optional<LaneId> lane);

  /**
   * Sets how fast it plays.
   *
   * @param factor 1 is as recorded; the nearest of {@link #SLOWEST} to {@link #FASTEST} is taken
   */
  void speed(double factor);

  /**
   * Sets whether it begins again at the end of what is played.
   *
   * @param again true where it does
   */
  void loop(boolean again);

  /**
   * Sets what is played.
   *
   * @param part a part of the span; none for all of it
   */
  void range(Optional<TimeRange> part);

  /**
   * Moves a recording against the others, for robots whose clocks differ. It is kept for the next time.
   *
   * @param track which
   * @param offset what is added to the times in its file, in nanoseconds
   */
  void shift(TrackId track, long offset);

  /**
   * Notes a time, in place of a bookmark of the same time. Bookmarks are kept beside what the application keeps.
   *
   * @param bookmark what is noted
   */
  void mark(Bookmark bookmark);

  /**
   * Forgets a bookmark.
   *
   * @param time of the bookmark
   */
  void unmark(long time);

  /**
   * Tells when recordings, what plays or how it plays change, and some ten times a second while the position moves.
   *
   * @param changed is called on a thread of the timeline; must not block
   * @return ends the subscription when closed
   */
  Subscription listen(Runnable changed);

  /**
   * One topic of one recording.
   *
   * @param track the recording
   * @param topic the name of the topic
   */
  record LaneId(TrackId track, String topic) {}
}
