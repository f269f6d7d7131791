package org.robotui.uic.topics.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.replay.StreamHistory;

/**
 * The messages of a recorded topic, at one moment.
 *
 * @param history where they are read; none where nothing is listed
 * @param obstacle why nothing is listed, empty where something is or nothing is wanted
 * @param rows those around the position of the timeline, by time
 * @param current the last one until the position
 * @param content of that
 */
public record MessageListing(Optional<StreamHistory> history, String obstacle, List<TimedMessage> rows,
    Optional<TimedMessage> current, Optional<MessageContent> content) {
  /** Nothing is wanted. */
  public static final MessageListing NOTHING =
      new MessageListing(Optional.empty(), "", List.of(), Optional.empty(), Optional.empty());

  static MessageListing obstacle(String why) {
    return new MessageListing(Optional.empty(), why, List.of(), Optional.empty(), Optional.empty());
  }

  /** Moves the timeline to a message. */
  public void seek(TimedMessage message) {
    history.ifPresent(all -> all.timeline().seek(message.time() + all.offset()));
  }
}
