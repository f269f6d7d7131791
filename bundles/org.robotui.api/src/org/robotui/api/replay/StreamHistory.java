package org.robotui.api.replay;

import java.io.IOException;
import java.util.Set;

/**
 * All values of the streams of a robot interface that plays a recording, past and future ones alike, whatever the
 * timeline shows. Streams of one recording have the same history, so that they can be read together. Times are those of
 * the recording, nanoseconds since 1970: they stay what they are when the recording is moved on the timeline. Safe for
 * all threads.
 */
public interface StreamHistory {
  /**
   * The timeline on which the recording lies.
   *
   * @return always the same
   */
  Timeline timeline();

  /**
   * When it was recorded.
   *
   * @return from the first to the last message
   */
  TimeRange span();

  /**
   * Where the recording lies on the timeline. Changes when a user moves the recording; the timeline tells it.
   *
   * @return what is to be added to its times, in nanoseconds
   */
  long offset();

  /**
   * How many messages a stream has, for who has to make room.
   *
   * @param port the name of a port of the robot interface
   * @return as the index of the file says, which is not checked: fewer may come of a damaged file; 0 where it has none
   */
  long count(String port);

  /**
   * Reads streams once, from the start of a range to its end. Blocks for the file, and for as long as the taker needs:
   * for a worker of who asks, such as that of {@link org.robotui.api.UicContext#background()}. Values are decoded one
   * after another on the calling thread, and nothing of them is kept. Several readings at once do not disturb each
   * other, nor what is played.
   *
   * @param ports names of ports of the robot interface; those that have no history give nothing
   * @param range of the recording's times, both ends in it
   * @param taker is given the values on this thread, by the times at which they were recorded, those of one time as
   * they lie in the file
   * @throws IOException where the file cannot be read any more, or the recording was closed meanwhile; what was given
   * before stays true
   * @throws InterruptedException where the thread was interrupted
   */
  void read(Set<String> ports, TimeRange range, HistoryTaker taker) throws IOException, InterruptedException;
}
