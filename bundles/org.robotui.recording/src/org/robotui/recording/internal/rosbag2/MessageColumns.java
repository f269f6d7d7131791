package org.robotui.recording.internal.rosbag2;

import java.util.Map;
import org.robotui.recording.internal.codec.ChunkDecoder;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.sqlite.SqliteRow;
import org.robotui.recording.internal.sqlite.SqliteTable;
import org.robotui.recording.internal.sqlite.SqliteValues;

/** Finds messages in the rows of their table. Immutable. */
final class MessageColumns {

  /**
   * A message in its row.
   *
   * @param channel its number in the recording
   * @param time when it was recorded, nanoseconds since 1970
   * @param start where its bytes begin in the row
   * @param length how many they are
   */
  record Found(int channel, long time, long start, int length) {}

  private final Map<Long, Integer> channels;
  private final int topic;
  private final int time;
  private final int data;

  /**
   * @param channels numbers of channels by those of their topics
   */
  MessageColumns(SqliteTable messages, Map<Long, Integer> channels) {
    this.channels = channels;
    this.topic = messages.column("topic_id");
    this.time = messages.column("timestamp");
    this.data = messages.column("data");
  }

  Found read(SqliteRow row, long mostBytes) throws MalformedRecord {
    SqliteValues values = row.values();
    long number = values.whole(topic);
    Integer channel = channels.get(number);
    if (channel == null) {
      throw new MalformedRecord("it is a message of topic " + number + ", which the file does not describe");
    }
    long length = values.size(data);
    if (length > Math.min(mostBytes, ChunkDecoder.MOST_BYTES)) {
      throw new MalformedRecord("it is a message of " + length + " bytes, more than are read");
    }
    return new Found(channel, values.whole(time), values.place(data), (int) length);
  }
}
