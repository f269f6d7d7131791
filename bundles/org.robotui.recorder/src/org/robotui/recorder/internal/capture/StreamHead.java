package org.robotui.recorder.internal.capture;

import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.api.record.RecordingStatus;
import org.robotui.recording.RecordedSchema;

/** What a series of messages has in common, and how many of them there were. Counted by several threads. */
public final class StreamHead {
  private final String robot;
  private final String topic;
  private final String encoding;
  private final RecordedSchema schema;
  private final Map<String, String> metadata;
  private final AtomicLong messages = new AtomicLong();
  private final AtomicLong bytes = new AtomicLong();
  private final AtomicLong dropped = new AtomicLong();

  /** Of what is recorded with a robot UI; its name is empty for what concerns all. */
  public StreamHead(String robot, String topic, String encoding, RecordedSchema schema, Map<String, String> metadata) {
    this.robot = robot;
    this.topic = topic;
    this.encoding = encoding;
    this.schema = schema;
    this.metadata = Map.copyOf(metadata);
  }

  /** The robot's name of where the messages come from. */
  public String topic() {
    return topic;
  }

  /** How their bytes are to be read. */
  public String encoding() {
    return encoding;
  }

  /** Their type. */
  public RecordedSchema schema() {
    return schema;
  }

  /** What else is noted of them. */
  public Map<String, String> metadata() {
    return metadata;
  }

  /** One was written. */
  public void wrote(int size) {
    messages.incrementAndGet();
    bytes.addAndGet(size);
  }

  /** Some could not be taken in time; a negative count takes that back. */
  public void dropped(long count) {
    dropped.addAndGet(count);
  }

  /** How many could not be taken in time. */
  public long dropped() {
    return dropped.get();
  }

  /** How many there were. */
  public RecordingStatus.Channel status() {
    return new RecordingStatus.Channel(robot, topic, schema.name(), messages.get(), bytes.get(), dropped.get());
  }
}
